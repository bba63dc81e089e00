#include "client/cli/overlay/solid_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fovea::cli {
namespace {

void Set(v1::Vector3* vector, double x, double y, double z) {
  vector->set_x(x);
  vector->set_y(y);
  vector->set_z(z);
}

v1::Object BoxAt(double x, double y, double z) {
  v1::Object object;
  Set(object.mutable_oriented_box()->mutable_pose()->mutable_position(), x, y, z);
  object.mutable_oriented_box()->mutable_pose()->mutable_orientation()->set_w(1);
  Set(object.mutable_oriented_box()->mutable_size(), 0.2, 0.1, 0.06);
  return object;
}

v1::Object Round(v1::ShapeKind kind) {
  v1::Object object = BoxAt(0.1, 0.2, 1);
  object.mutable_shape()->set_kind(kind);
  Set(object.mutable_shape()->mutable_center(), 0.1, 0.2, 1);
  object.mutable_shape()->set_radius_m(0.04);
  return object;
}

long NumHidden(const std::vector<SpaceLine>& lines) {
  return std::count_if(lines.begin(), lines.end(),
                       [](const SpaceLine& line) { return line.hidden; });
}

TEST(CollisionLines, AreThoseOfTheSolid) {
  v1::Object cylinder = Round(v1::SHAPE_KIND_CYLINDER);
  Set(cylinder.mutable_shape()->mutable_axis(), 0, 0, 1);
  cylinder.mutable_shape()->set_length_m(0.06);
  v1::CollisionPrimitive primitive;
  *primitive.mutable_pose() = cylinder.oriented_box().pose();
  Set(primitive.mutable_size(), 0.08, 0.08, 0.06);
  primitive.set_kind(v1::COLLISION_KIND_CYLINDER);
  const std::vector<SpaceLine> expected = LinesOf(cylinder), lines = LinesOf(primitive);
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_LT(cv::norm(lines[i].from - expected[i].from), 1e-9);
    EXPECT_LT(cv::norm(lines[i].to - expected[i].to), 1e-9);
  }
  primitive.set_kind(v1::COLLISION_KIND_SPHERE);
  EXPECT_EQ(LinesOf(primitive).size(), LinesOf(Round(v1::SHAPE_KIND_SPHERE)).size());
  primitive.set_kind(v1::COLLISION_KIND_BOX);
  EXPECT_EQ(LinesOf(primitive).size(), 12U);
}

TEST(BoxLines, HideWhatIsBehindTheFacesThatAreSeen) {
  // Of a box whose corner is nearest, three edges meet at the corner that is farthest.
  const std::vector<SpaceLine> lines = LinesOf(BoxAt(0.5, 0.5, 1));
  EXPECT_EQ(lines.size(), 12U);
  EXPECT_EQ(NumHidden(lines), 3);
  EXPECT_EQ(NumHidden(LinesOf(BoxAt(0, 0, 1))), 8) << "all but those of the one face that is seen";
}

TEST(RoundLines, LieOnTheCylinderAndItsOutlineTouchesLinesOfSight) {
  v1::Object can = Round(v1::SHAPE_KIND_CYLINDER);
  Set(can.mutable_shape()->mutable_axis(), 0, -1, 0);
  can.mutable_shape()->set_length_m(0.12);
  const std::vector<SpaceLine> lines = LinesOf(can);
  ASSERT_EQ(lines.size(), 2U * 48 + 2);
  for (const SpaceLine& line : lines) {
    EXPECT_NEAR(std::hypot(line.from[0] - 0.1, line.from[2] - 1), 0.04, 1e-9);
    EXPECT_NEAR(std::abs(line.from[1] - 0.2), 0.06, 1e-9);
  }
  for (const SpaceLine& outline : {lines[96], lines[97]}) {
    const cv::Vec3d normal(outline.from[0] - 0.1, 0, outline.from[2] - 1);
    EXPECT_NEAR(normal.dot(outline.from), 0, 1e-9);
  }
  // The camera looks down on it: all of the upper ring is seen, of the lower one the front.
  EXPECT_GT(NumHidden(lines), 20);
  EXPECT_LT(NumHidden(lines), 28);
  const auto axis = AxisOf(can);
  ASSERT_TRUE(axis);
  EXPECT_NEAR(cv::norm(axis->to - axis->from), 0.15, 1e-9);
}

TEST(RoundLines, FollowTheProfileOfABowl) {
  v1::Object bowl = Round(v1::SHAPE_KIND_REVOLUTION);
  Set(bowl.mutable_shape()->mutable_axis(), 0, -1, 0);
  bowl.mutable_shape()->set_length_m(0.08);
  for (const double radius : {0.02, 0.03, 0.04, 0.05}) bowl.mutable_shape()->add_radii_m(radius);
  double lowest = 0, highest = 0;
  for (const SpaceLine& line : LinesOf(bowl)) {
    const double radius = std::hypot(line.from[0] - 0.1, line.from[2] - 1);
    if (std::abs(line.from[1] - 0.24) < 1e-9) lowest = radius;
    if (std::abs(line.from[1] - 0.16) < 1e-9) highest = radius;
  }
  EXPECT_NEAR(lowest, 0.02, 1e-9);
  EXPECT_NEAR(highest, 0.05, 1e-9);
}

TEST(BallLines, LieOnTheBall) {
  const v1::Object ball = Round(v1::SHAPE_KIND_SPHERE);
  const std::vector<SpaceLine> lines = LinesOf(ball);
  EXPECT_EQ(lines.size(), 2U * 48);
  for (const SpaceLine& line : lines) {
    EXPECT_NEAR(cv::norm(line.from - cv::Vec3d(0.1, 0.2, 1)), 0.04, 1e-9);
  }
  EXPECT_FALSE(AxisOf(ball));
}

}  // namespace
}  // namespace fovea::cli
