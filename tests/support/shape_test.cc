#include "tests/support/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fovea::scenes {
namespace {

using Eigen::Vector3d;

// Where a ray that comes from far away along -z above (x, y) meets the shape.
std::optional<Hit> HitFromAbove(const Shape& shape, double x, double y) {
  return Intersect(shape, {{x, y, 10}, {0, 0, -1}});
}

TEST(Shape, BoxIsHitOnTheFaceThatTheRayMeets) {
  const Shape box = {ShapeKind::kBox, {2, 4, 6}, 0, {}};
  const auto top = HitFromAbove(box, 0.9, -1.9);
  ASSERT_TRUE(top);
  EXPECT_DOUBLE_EQ(top->t, 7);
  EXPECT_EQ(top->normal, Vector3d::UnitZ());
  EXPECT_FALSE(HitFromAbove(box, 1.1, 0));
  const auto side = Intersect(box, {{-5, 0, 0}, {2, 0, 0}});
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side->t, 2) << "t counts lengths of the direction";
  EXPECT_EQ(side->normal, -Vector3d::UnitX());
}

TEST(Shape, IsNotHitBehindTheOriginOrBeyondTheLimit) {
  const Shape ball = {ShapeKind::kSphere, {2, 2, 2}, 0, {}};
  EXPECT_FALSE(Intersect(ball, {{0, 0, 5}, {0, 0, 1}}));
  EXPECT_FALSE(Intersect(ball, {{0, 0, 5}, {0, 0, -1}}, 3.9));
  EXPECT_TRUE(Intersect(ball, {{0, 0, 5}, {0, 0, -1}}, 4.1));
}

TEST(Shape, RoundShapesHaveTheirRadius) {
  const auto ball = HitFromAbove({ShapeKind::kSphere, {2, 2, 2}, 0, {}}, 0.6, 0);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->t, 10 - 0.8, 1e-12);
  EXPECT_TRUE(ball->normal.isApprox(Vector3d(0.6, 0, 0.8), 1e-12));
  const Shape can = {ShapeKind::kCylinder, {2, 2, 4}, 0, {}};
  EXPECT_TRUE(HitFromAbove(can, 0.7, 0.7));
  EXPECT_FALSE(HitFromAbove(can, 0.72, 0.72));
}

TEST(Shape, HollowShapesShowTheirInside) {
  const Shape cup = {ShapeKind::kCup, {2, 2, 4}, 0.1, {}};
  EXPECT_NEAR(HitFromAbove(cup, 0, 0)->t, 10 + 2 - 0.1, 1e-12) << "the inner floor";
  EXPECT_NEAR(HitFromAbove(cup, 0.95, 0)->t, 8, 1e-12) << "the rim";
  const auto wall = Intersect(cup, {{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(wall) << "from within the hollow";
  EXPECT_NEAR(wall->t, 0.9, 1e-12);
  EXPECT_TRUE(wall->normal.isApprox(-Vector3d::UnitX(), 1e-12));

  const Shape bowl = {ShapeKind::kBowl, {2, 2, 0.8}, 0.05, {}};
  const auto bottom = HitFromAbove(bowl, 0, 0);
  ASSERT_TRUE(bottom);
  EXPECT_NEAR(bottom->t, 10 + 0.4 - 0.05, 1e-12);
  EXPECT_TRUE(HitFromAbove(bowl, 0.99, 0));
  EXPECT_FALSE(HitFromAbove(bowl, 1.01, 0));
}

// A box of 2 × 2 × 2 with a ball of diameter 2 of another material on its right.
Shape BoxAndBall() {
  Part box = {{ShapeKind::kBox, {2, 2, 2}, 0, {}}};
  Part ball = {{ShapeKind::kSphere, {2, 2, 2}, 0, {}}, Eigen::Isometry3d::Identity(), 1};
  ball.shape_from_part.translation().x() = 4;
  return CompoundOf({box, ball});
}

TEST(Shape, CompoundIsCentredInTheBoxAroundItsParts) {
  const Shape shape = BoxAndBall();
  EXPECT_EQ(shape.size_m, Vector3d(6, 2, 2));
  EXPECT_EQ(shape.parts[0].shape_from_part.translation(), Vector3d(-2, 0, 0));
  EXPECT_EQ(shape.parts[1].shape_from_part.translation(), Vector3d(2, 0, 0));

  Part slanted = {{ShapeKind::kBox, {2, 2, 4}, 0, {}}};
  slanted.shape_from_part.rotate(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitY()));
  const double diagonal = 6 / std::numbers::sqrt2;
  EXPECT_TRUE(CompoundOf({slanted}).size_m.isApprox(Vector3d(diagonal, 2, diagonal), 1e-12));
  slanted.shape.kind = ShapeKind::kCylinder;
  EXPECT_TRUE(CompoundOf({slanted}).size_m.isApprox(Vector3d(diagonal, 2, diagonal), 1e-12));
}

TEST(Shape, CompoundIsHitAtTheNearestOfItsParts) {
  const Shape shape = BoxAndBall();
  const auto box = Intersect(shape, {{-10, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(box);
  EXPECT_DOUBLE_EQ(box->t, 7);
  EXPECT_EQ(box->material, 0);
  const auto ball = Intersect(shape, {{10, 0, 0}, {-1, 0, 0}});
  ASSERT_TRUE(ball);
  EXPECT_DOUBLE_EQ(ball->t, 7);
  EXPECT_EQ(ball->normal, Vector3d::UnitX());
  EXPECT_EQ(ball->material, 1);
  EXPECT_FALSE(HitFromAbove(shape, 0, 0)) << "between the parts";
  const auto leaving = Intersect(shape, {{-1 + 1e-4, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(leaving) << "from the surface of one part to another";
  EXPECT_NEAR(leaving->t, 2 - 1e-4, 1e-12);
}

TEST(Shape, ASmoothCushionIsFlatBelowAndFullInTheMiddle) {
  const Shape cushion = {ShapeKind::kCushion, {2, 2, 1}, 0, {}, {.fullness = 1}};
  const auto top = HitFromAbove(cushion, 0, 0);
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->t, 9.5, 1e-6);
  EXPECT_TRUE(top->normal.isApprox(Vector3d::UnitZ(), 1e-6));
  const auto slope = HitFromAbove(cushion, 0.5, 0);  // z = 1 - x² above the bottom
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->t, 10.5 - 0.75, 1e-6);
  EXPECT_TRUE(slope->normal.isApprox(Vector3d(1, 0, 1).normalized(), 1e-3));
  const auto below = Intersect(cushion, {{0, 0, -5}, {0, 0, 1}});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->normal, -Vector3d::UnitZ());
  EXPECT_FALSE(HitFromAbove(cushion, 1.01, 0));
  EXPECT_FALSE(Intersect(cushion, {{-5, 0.95, 0.4}, {1, 0, 0}})) << "over the low edge";
}

TEST(Shape, CreasesOfACushionStayWithinItsHeight) {
  const Relief relief = {.fullness = 4, .depth_m = 0.04, .scale_m = 0.05, .seed = 7};
  const Shape cushion = {ShapeKind::kCushion, {0.2, 0.2, 0.06}, 0, {}, relief};
  double least = 1, most = 0;
  for (int column = -5; column <= 5; ++column) {
    for (int row = -5; row <= 5; ++row) {
      const double x = 0.01 * column, y = 0.01 * row;
      const auto hit = HitFromAbove(cushion, x, y);
      ASSERT_TRUE(hit);
      const double height = 10.03 - hit->t;
      least = std::min(least, height);
      most = std::max(most, height);
      const auto slanted = Intersect(cushion, {{x - 1, y, 1}, {1, 0, -1}});
      ASSERT_TRUE(slanted);
      const Vector3d at = Vector3d(x - 1, y, 1) + slanted->t * Vector3d(1, 0, -1);
      const auto same = HitFromAbove(cushion, at.x(), at.y());
      ASSERT_TRUE(same);
      EXPECT_NEAR(10 - same->t, at.z(), 1e-6) << "from any side the same surface";
    }
  }
  EXPECT_GT(least, 0.02 - 1e-9);
  EXPECT_LE(most, 0.06);
  EXPECT_GT(most - least, 0.01);
}

TEST(Shape, NormalsOfPartsTurnWithThem) {
  Part slanted = {{ShapeKind::kBox, {2, 2, 2}, 0, {}}};
  slanted.shape_from_part.rotate(Eigen::AngleAxisd(std::numbers::pi / 6, Vector3d::UnitY()));
  const auto hit = HitFromAbove(CompoundOf({slanted}), 0, 0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 10 - 1 / std::cos(std::numbers::pi / 6), 1e-12);
  EXPECT_TRUE(hit->normal.isApprox(Vector3d(0.5, 0, std::sqrt(0.75)), 1e-12));
}

}  // namespace
}  // namespace fovea::scenes
