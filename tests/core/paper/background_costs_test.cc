#include "core/paper/background_costs.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "tests/core/segmentation/seeded_points.h"

namespace fovea::paper {
namespace {

void ExpectAsPrinted(const SeededPoints& scene) {
  const DataTermOptions options;
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  const auto costs = BackgroundCosts(scene.grid, scene.points, none, {}, scene.seeds, options);
  ASSERT_EQ(costs.size(), scene.grid.voxels.size());
  for (std::size_t v = 0; v < costs.size(); ++v) {
    EXPECT_NEAR(costs[v], LiteralCost(scene, static_cast<int>(v), 0, options), 2e-3) << v;
  }
}

TEST(BackgroundCosts, AreAsPrinted) { ExpectAsPrinted(RandomPoints(11)); }

// Their only point is as far from the nearest seed as their mean: rounding must not lose that seed.
TEST(BackgroundCosts, OfSinglePointsKnowTheirNearestSeed) {
  const SeededPoints scene = RandomPoints(12, 1e-4);
  ASSERT_EQ(scene.grid.voxels.size(), scene.points.total());
  ExpectAsPrinted(scene);
}

// A voxel of two points, 2 cm apart: the right one is nearest to the seed that is farther from
// their mean. The third seed is farther from both.
TEST(BackgroundCosts, OfWideVoxelsKnowTheNearestSeedOfEachPoint) {
  SeededPoints scene;
  scene.points = cv::Mat(1, 2, CV_32FC3, cv::Scalar(0.02, 0.05, 1.01));
  scene.points.at<cv::Vec3f>(0, 1)[0] = 0.04F;
  const cv::Mat normals(scene.points.size(), CV_32FC3, cv::Scalar(0, 0, -1));
  scene.grid = BuildVoxelGrid(scene.points, {normals}, {.size_m = 0.05});
  ASSERT_EQ(scene.grid.voxels.size(), 1U);
  for (const float x_m : {0.01F, 0.065F, 0.2F}) scene.seeds.push_back({{}, {x_m, 0.05F, 1.01F}});
  const DataTermOptions options{.gamma_per_m2 = 1000};
  const auto costs = BackgroundCosts(scene.grid, scene.points, {0}, {}, scene.seeds, options);
  EXPECT_NEAR(costs.front(), LiteralCost(scene, 0, 0, options), 1e-4);
  scene.seeds[1] = scene.seeds[2];  // and it matters
  EXPECT_LT(LiteralCost(scene, 0, 0, options), costs.front() - 0.1);
}

// Section 3.2: "a probability value of one" for the background.
TEST(BackgroundCosts, AreNothingWhereThePointsAreOnTheSupport) {
  const SeededPoints scene = RandomPoints(14);
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  cv::Mat on_support = cv::Mat::zeros(scene.points.size(), CV_8UC1);
  on_support.setTo(255, scene.grid.voxel_of_pixel == 2);
  const auto costs = BackgroundCosts(scene.grid, scene.points, none, on_support, scene.seeds, {});
  const auto plain = BackgroundCosts(scene.grid, scene.points, none, {}, scene.seeds, {});
  for (std::size_t v = 0; v < costs.size(); ++v) EXPECT_EQ(costs[v], v == 2 ? 0 : plain[v]) << v;
  // Of a voxel with one of n points on it, n - 1 count.
  on_support.setTo(0);
  cv::Mat last;
  cv::findNonZero(scene.grid.voxel_of_pixel == 2, last);
  const cv::Point pixel = last.at<cv::Point>(0);
  on_support.at<std::uint8_t>(pixel) = 255;
  const auto mixed = BackgroundCosts(scene.grid, scene.points, none, on_support, scene.seeds, {});
  EXPECT_LT(mixed[2], plain[2]);
  EXPECT_GT(mixed[2], 0);
}

}  // namespace
}  // namespace fovea::paper
