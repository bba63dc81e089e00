#include "core/scene/level_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fovea {
namespace {

const Eigen::Vector3f kPointsUp = -Eigen::Vector3f::UnitY();

// A table of 60 x 60 cm at y = 1, at 1.5 to 2.1 m, with 2 mm of noise. Its right two fifths are
// covered by a slab.
std::vector<Eigen::Vector3f> TableWithSlab(float slab_m) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 0.002F);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      const float x = 0.01F * static_cast<float>(i) - 0.295F;
      const float z = 0.01F * static_cast<float>(j) + 1.5F;
      points.emplace_back(x, 1 - (x > 0.06F ? slab_m : 0) + noise(random), z);
    }
  }
  return points;
}

constexpr SupportOptions kFitOptions{.tolerance_m = 0.02, .common_height_fits = 3};

TEST(FitLevelSurface, IsNotTiltedByALowThingOnIt) {
  const auto points = TableWithSlab(0.015F);
  const SupportSurface surface = FitLevelSurface(points, kPointsUp, kFitOptions);
  EXPECT_NEAR(surface.HeightOf({-0.25F, 1, 1.8F}), 0, 0.002F);
  EXPECT_NEAR(surface.HeightOf({0.25F, 1, 1.8F}), 0, 0.002F);
  SupportOptions wide = kFitOptions;
  wide.common_height_fits = 0;
  const SupportSurface tilted = FitLevelSurface(points, kPointsUp, wide);
  EXPECT_LT(tilted.HeightOf({0.25F, 1, 1.8F}), -0.005F);
}

TEST(FitLevelSurface, FollowsATableThatIsNotQuiteLevel) {
  std::vector<Eigen::Vector3f> points = TableWithSlab(0);
  const float slope = std::tan(1.0F * 3.14159F / 180);
  for (Eigen::Vector3f& point : points) point.y() += slope * point.x();
  const SupportSurface surface = FitLevelSurface(points, kPointsUp, kFitOptions);
  EXPECT_NEAR(surface.HeightOf({0.25F, 1 + slope * 0.25F, 1.8F}), 0, 0.001F);
  EXPECT_EQ(surface.num_points, points.size());
}

TEST(FitLevelSurface, KeepsTheHeightOfTooFewPointsForAPlane) {
  const SupportSurface surface = FitLevelSurface({{0, 1, 1}, {0.1F, 1, 1}}, kPointsUp, kFitOptions);
  EXPECT_EQ(surface.normal, kPointsUp);
  EXPECT_NEAR(surface.HeightOf({0, 1, 1}), 0, 0.005F);
}

TEST(FitAnew, GoesToThePointsFromAPlaneThatIsTooHigh) {
  const auto points = TableWithSlab(0.015F);
  const SupportSurface high{kPointsUp, 1 - 0.006F, 7};
  const SupportSurface anew = FitAnew(points, high, kFitOptions);
  EXPECT_NEAR(anew.HeightOf({-0.25F, 1, 1.8F}), 0, 0.001F);
  EXPECT_NEAR(anew.HeightOf({0.05F, 1, 1.8F}), 0, 0.001F);
  EXPECT_EQ(anew.num_points, high.num_points);
}

TEST(FitAnew, KeepsThePlaneWhereFewPointsTell) {
  const auto points = TableWithSlab(0);
  const SupportSurface high{kPointsUp, 1 - 0.006F, 7};
  const SupportSurface anew = FitAnew({points.begin(), points.begin() + 49}, high, kFitOptions);
  EXPECT_EQ(anew.normal, high.normal);
  EXPECT_EQ(anew.offset_m, high.offset_m);
}

}  // namespace
}  // namespace fovea
