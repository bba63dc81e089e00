#include "tests/support/shape.h"

#include <gtest/gtest.h>

namespace fovea::scenes {
namespace {

using Eigen::Vector3d;

// Where a ray that comes from far away along -z above (x, y) meets the shape.
std::optional<Hit> FromAbove(const Shape& shape, double x, double y) {
  return Intersect(shape, {{x, y, 10}, {0, 0, -1}});
}

TEST(Shape, BoxIsHitOnTheFaceThatTheRayMeets) {
  const Shape box = {ShapeKind::kBox, {2, 4, 6}, 0};
  const auto top = FromAbove(box, 0.9, -1.9);
  ASSERT_TRUE(top);
  EXPECT_DOUBLE_EQ(top->t, 7);
  EXPECT_EQ(top->normal, Vector3d::UnitZ());
  EXPECT_FALSE(FromAbove(box, 1.1, 0));
  const auto side = Intersect(box, {{-5, 0, 0}, {2, 0, 0}});
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side->t, 2) << "t counts lengths of the direction";
  EXPECT_EQ(side->normal, -Vector3d::UnitX());
}

TEST(Shape, IsNotHitBehindTheOriginOrBeyondTheLimit) {
  const Shape ball = {ShapeKind::kSphere, {2, 2, 2}, 0};
  EXPECT_FALSE(Intersect(ball, {{0, 0, 5}, {0, 0, 1}}));
  EXPECT_FALSE(Intersect(ball, {{0, 0, 5}, {0, 0, -1}}, 3.9));
  EXPECT_TRUE(Intersect(ball, {{0, 0, 5}, {0, 0, -1}}, 4.1));
}

TEST(Shape, RoundShapesHaveTheirRadius) {
  const auto ball = FromAbove({ShapeKind::kSphere, {2, 2, 2}, 0}, 0.6, 0);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->t, 10 - 0.8, 1e-12);
  EXPECT_TRUE(ball->normal.isApprox(Vector3d(0.6, 0, 0.8), 1e-12));
  const Shape can = {ShapeKind::kCylinder, {2, 2, 4}, 0};
  EXPECT_TRUE(FromAbove(can, 0.7, 0.7));
  EXPECT_FALSE(FromAbove(can, 0.72, 0.72));
}

TEST(Shape, HollowShapesShowTheirInside) {
  const Shape cup = {ShapeKind::kCup, {2, 2, 4}, 0.1};
  EXPECT_NEAR(FromAbove(cup, 0, 0)->t, 10 + 2 - 0.1, 1e-12) << "the inner floor";
  EXPECT_NEAR(FromAbove(cup, 0.95, 0)->t, 8, 1e-12) << "the rim";
  const auto wall = Intersect(cup, {{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(wall) << "from within the hollow";
  EXPECT_NEAR(wall->t, 0.9, 1e-12);
  EXPECT_TRUE(wall->normal.isApprox(-Vector3d::UnitX(), 1e-12));

  const Shape bowl = {ShapeKind::kBowl, {2, 2, 0.8}, 0.05};
  const auto bottom = FromAbove(bowl, 0, 0);
  ASSERT_TRUE(bottom);
  EXPECT_NEAR(bottom->t, 10 + 0.4 - 0.05, 1e-12);
  EXPECT_TRUE(FromAbove(bowl, 0.99, 0));
  EXPECT_FALSE(FromAbove(bowl, 1.01, 0));
}

}  // namespace
}  // namespace fovea::scenes
