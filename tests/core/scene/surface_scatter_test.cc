#include "core/scene/surface_scatter.h"

#include <gtest/gtest.h>

#include <random>

namespace fovea {
namespace {

constexpr SupportOptions kOptions{.tolerance_m = 0.01, .tolerance_sigmas = 3.5};

// Level, one metre below the camera; y points down.
const SupportSurface kFloor{-Eigen::Vector3f::UnitY(), 1.0F, 1};

std::vector<Eigen::Vector3f> Floor(float sigma_m) {
  std::mt19937 random(7);
  std::normal_distribution<float> noise(0, sigma_m);
  std::vector<Eigen::Vector3f> points(4000, {0, 0, 2});
  for (Eigen::Vector3f& point : points) point.y() = 1 + noise(random);
  return points;
}

TEST(ToleranceShare, IsThatOfSomeStandardDeviations) {
  EXPECT_NEAR(ToleranceShare(Floor(0.002F), kFloor, kOptions), 3.5 * 0.002 / 0.01, 0.03);
}

TEST(ToleranceShare, StaysWithinLimits) {
  EXPECT_EQ(ToleranceShare(Floor(0.0001F), kFloor, kOptions), 0.35F);
  EXPECT_NEAR(ToleranceShare(Floor(0.005F), kFloor, kOptions), 3.5 * 0.005 / 0.01, 0.08);
  EXPECT_EQ(ToleranceShare(Floor(0.008F), kFloor, kOptions), 2.5F);
}

TEST(ToleranceShare, DoesNotMindLowObjects) {
  std::vector<Eigen::Vector3f> points = Floor(0.002F);
  const float alone = ToleranceShare(points, kFloor, kOptions);
  points.insert(points.end(), 4000, {0, 0.992F, 2});  // 8 mm high
  EXPECT_EQ(ToleranceShare(points, kFloor, kOptions), alone);
}

TEST(ToleranceShare, IsRelativeToTheToleranceThatGrowsWithDistance) {
  const SupportOptions growing{
      .tolerance_m = 0.002, .tolerance_per_m = 0.002, .tolerance_sigmas = 3.5};
  EXPECT_FLOAT_EQ(ToleranceShare(Floor(0.002F), kFloor, growing),  // 1 cm at 2 m
                  ToleranceShare(Floor(0.002F), kFloor, kOptions));
}

TEST(ToleranceShare, IsOneWhereNothingSpeaksForLess) {
  EXPECT_EQ(ToleranceShare({}, kFloor, kOptions), 1);
  EXPECT_EQ(ToleranceShare({{0, 0.995F, 2}}, kFloor, kOptions), 1);  // nothing below
  EXPECT_EQ(ToleranceShare(Floor(0.002F), kFloor, {.tolerance_m = 0.01}), 1);
}

}  // namespace
}  // namespace fovea
