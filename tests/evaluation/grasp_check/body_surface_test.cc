#include "tests/evaluation/grasp_check/body_surface.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/evaluation/grasp_check/solid_box.h"
#include "tests/support/compound_parts.h"

namespace fovea::evaluation {
namespace {

using Eigen::Vector3d;
using scenes::ShapeKind;

TEST(BodySurface, PointsAreEvenlyDense) {
  const double pi = std::numbers::pi;
  const std::size_t of_ball =
      SampleSurface({ShapeKind::kSphere, {0.1, 0.1, 0.1}, 0, {}}, 1e-3).size();
  EXPECT_NEAR(static_cast<double>(of_ball), pi * 0.01 / 1e-6, 0.02 * pi * 0.01 / 1e-6);
}

TEST(BodySurface, HasTheInsideOfACup) {
  const scenes::Shape cup = {ShapeKind::kCup, {0.08, 0.08, 0.1}, 0.005, {}};
  int inside = 0;
  for (const Vector3d& point : SampleSurface(cup, 0.002)) {
    const double radius = point.head<2>().norm();
    inside += std::abs(radius - 0.035) < 1e-6 && std::abs(point.z()) < 0.045;
  }
  EXPECT_GT(inside, 2 * std::numbers::pi * 35 * 90 / 4 / 1.5);
}

TEST(BodySurface, CenterOfMassOfACompound) {
  // A heavy head of 8 cm³ and a light handle of 2.
  const scenes::Shape hammer =
      scenes::CompoundOf({scenes::BlockPart({0, 0, 0}, {0.02, 0.02, 0.02}),
                          scenes::BlockPart({0.06, 0, 0}, {0.1, 0.01, 0.002})});
  // In its own frame the bounding box from -0.01 to 0.11 is centred at 0.05.
  EXPECT_NEAR(CenterOfMass(hammer).x(), 0.2 * 0.06 - 0.05, 1e-9);
}

TEST(SolidBox, MeetsWhereTheyShareVolume) {
  SolidBox a, b;
  a.half_m = b.half_m = {0.1, 0.1, 0.1};
  b.world_from_box.translation() = Vector3d(0.199, 0, 0);
  EXPECT_TRUE(Meet(a, b));
  b.world_from_box.translation() = Vector3d(0.201, 0, 0);
  EXPECT_FALSE(Meet(a, b));
  // An edge towards a face reaches √2 as far; two crossed edges meet in one point.
  b.world_from_box.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()).toRotationMatrix();
  b.world_from_box.translation() = Vector3d(0.24, 0, 0);
  EXPECT_TRUE(Meet(a, b));
  b.world_from_box.translation() = Vector3d(0.242, 0, 0);
  EXPECT_FALSE(Meet(a, b));
}

}  // namespace
}  // namespace fovea::evaluation
