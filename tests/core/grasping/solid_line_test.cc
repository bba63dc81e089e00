#include "core/grasping/solid_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea {
namespace {

using Eigen::Vector3f;

// A metre in front of the camera, upright along -y, long along x.
DetectedObject ObjectOf(Shape::Kind kind, const Vector3f& size_m) {
  DetectedObject object;
  object.box.center = {0, 0, 1};
  object.box.size_m = size_m;
  object.box.rotation.col(0) = Vector3f::UnitX();
  object.box.rotation.col(1) = Vector3f::UnitZ();
  object.box.rotation.col(2) = -Vector3f::UnitY();
  object.shape.kind = kind;
  object.shape.center = object.box.center;
  return object;
}

// Along z through (x, y), in the camera frame; 0 if it misses.
Span Through(const DetectedObject& object, float x, float y) {
  Lines lines;
  lines.Add({x, y, 0}, Vector3f::UnitZ());
  std::vector<Span> spans;
  CompletedSolid(object, LevelFrame()).Along(lines, spans);
  return spans.at(0).IsEmpty() ? Span() : spans[0];
}

TEST(CompletedSolid, OfABoxIsItsBox) {
  const Span span = Through(ObjectOf(Shape::Kind::kBox, {0.2F, 0.1F, 0.1F}), 0.09F, 0);
  EXPECT_NEAR(span.low, 0.95F, 1e-6F);
  EXPECT_NEAR(span.high, 1.05F, 1e-6F);
}

TEST(CompletedSolid, OfACylinderIsRound) {
  DetectedObject object = ObjectOf(Shape::Kind::kCylinder, {0.1F, 0.1F, 0.2F});
  object.shape.axis = -Vector3f::UnitY();
  object.shape.radius_m = 0.05F;
  object.shape.length_m = 0.2F;
  EXPECT_NEAR(Through(object, 0.03F, 0.09F).low, 0.96F, 1e-6F);  // 3-4-5
  EXPECT_EQ(Through(object, 0, 0.11F).high, 0);
}

TEST(CompletedSolid, OfWhatIsOfRevolutionHasItsRadii) {
  DetectedObject object = ObjectOf(Shape::Kind::kRevolution, {0.1F, 0.1F, 0.2F});
  object.shape.axis = -Vector3f::UnitY();
  object.shape.radius_m = 0.05F;
  object.shape.length_m = 0.2F;
  object.shape.radii_m = {0.02F, 0.05F};  // the lower half first: +y
  EXPECT_NEAR(Through(object, 0, 0.05F).low, 0.98F, 1e-6F);
  EXPECT_NEAR(Through(object, 0, -0.05F).low, 0.95F, 1e-6F);
}

TEST(CompletedSolid, OfWhatIsOblongHasRoundEnds) {
  DetectedObject object = ObjectOf(Shape::Kind::kOther, {0.2F, 0.1F, 0.1F});
  EXPECT_FALSE(CompletedSolid(object, LevelFrame()).IsKnown());
  EXPECT_NEAR(Through(object, 0.08F, 0).low, 0.95F, 1e-6F);  // its box
  object.shape.form = Shape::Form::kOblong;
  EXPECT_TRUE(CompletedSolid(object, LevelFrame()).IsKnown());
  EXPECT_NEAR(Through(object, 0.04F, 0).low, 0.95F, 1e-6F);
  EXPECT_NEAR(Through(object, 0.08F, 0).low, 0.96F, 1e-6F);  // 3-4-5 about (0.05, 1)
  EXPECT_EQ(Through(object, 0.11F, 0).high, 0);
}

TEST(CompletedSolid, OfABentRodGoesToWhereItIsBent) {
  DetectedObject object = ObjectOf(Shape::Kind::kOther, {0.24F, 0.1F, 0.04F});
  object.shape.form = Shape::Form::kBent;
  object.shape.bend_m = 0.06F;        // towards +z of the camera
  constexpr float kPieces_m = 1e-3F;  // between a curve and its pieces
  EXPECT_NEAR(Through(object, 0, 0).low, 0.95F, kPieces_m);
  EXPECT_NEAR(Through(object, 0, 0).high, 0.99F, kPieces_m);
  EXPECT_NEAR(Through(object, 0.1F, 0).high, 1.05F, kPieces_m);
  object.shape.bend_m = -0.06F;
  EXPECT_NEAR(Through(object, 0, 0).high, 1.05F, kPieces_m);
}

// More than are looked at at once, and a number of them that fills no whole part.
TEST(CompletedSolid, TellsOfManyLinesWhatItTellsOfEach) {
  DetectedObject object = ObjectOf(Shape::Kind::kCylinder, {0.1F, 0.1F, 0.2F});
  object.shape.axis = -Vector3f::UnitY();
  object.shape.radius_m = 0.05F;
  object.shape.length_m = 0.2F;
  Lines lines;
  const auto x_of = [](int i) { return 0.001F * static_cast<float>(i - 60); };
  for (int i = 0; i < 121; ++i) lines.Add({x_of(i), 0, 0}, Vector3f::UnitZ());
  std::vector<Span> spans;
  CompletedSolid(object, LevelFrame()).Along(lines, spans);
  ASSERT_EQ(spans.size(), 121);
  for (int i = 0; i < 121; ++i) {
    const Span one = Through(object, x_of(i), 0);
    EXPECT_EQ(spans[i].IsEmpty(), std::abs(x_of(i)) >= 0.05F) << x_of(i);
    if (spans[i].IsEmpty()) continue;
    EXPECT_EQ(spans[i].low, one.low);
    EXPECT_EQ(spans[i].high, one.high);
    EXPECT_NEAR((spans[i].high - spans[i].low) / 2, std::sqrt(0.05F * 0.05F - x_of(i) * x_of(i)),
                1e-5F);
  }
}

TEST(CompletedSolid, LinesBesideAFaceStayOutsideAndOnesInItInside) {
  const DetectedObject object = ObjectOf(Shape::Kind::kBox, {0.2F, 0.1F, 0.1F});
  EXPECT_EQ(Through(object, 0.1001F, 0).high, 0);
  EXPECT_GT(Through(object, 0.0999F, 0).high, 0);
}

}  // namespace
}  // namespace fovea
