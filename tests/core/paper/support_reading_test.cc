#include "core/paper/support_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fovea::paper {
namespace {

using ::testing::ElementsAre;

// Level, one metre ahead of a camera that looks straight down: heights grow towards it.
const SupportSurface kTable{{0, 0, -1}, 1.0F, 1000};

// 5 cm above the table, on it, 5 cm below, without depth.
cv::Mat Points() {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return (cv::Mat_<cv::Vec3f>(1, 4) << cv::Vec3f(0, 0, 0.95F), cv::Vec3f(0, 0, 1),
          cv::Vec3f(0, 0, 1.05F), cv::Vec3f(nan, nan, nan));
}

std::vector<int> OnSupport(const PaperOptions& options) {
  const cv::Mat on = PointsOfSupport(Points(), kTable, options);
  std::vector<int> values;
  for (int col = 0; col < on.cols; ++col) values.push_back(on.at<std::uint8_t>(0, col) > 0);
  return values;
}

TEST(PointsOfSupport, AreOnTheSurfaceAndBelowItAsRead) {
  PaperOptions options;
  EXPECT_THAT(OnSupport(options), ElementsAre(0, 1, 1, 0));
  options.support_reading.includes_below = false;
  EXPECT_THAT(OnSupport(options), ElementsAre(0, 1, 0, 0));
  options.support_reading.hard = true;
  EXPECT_TRUE(PointsOfSupport(Points(), kTable, options).empty());
  EXPECT_TRUE(PointsOfSupport(Points(), std::nullopt, {}).empty());
}

TEST(SeedsAt, TakesThePixelsThatHaveDepth) {
  const SalientPositions positions = SeedsAt({{0, 0}, {3, 0}}, Points());
  ASSERT_EQ(positions.seeds.size(), 1U);
  EXPECT_FLOAT_EQ(positions.seeds[0].position.z(), 0.95F);
  ASSERT_EQ(positions.removed.size(), 1U);
  EXPECT_EQ(positions.removed[0].pixel, cv::Point(3, 0));
  EXPECT_EQ(positions.removed[0].reason, RemovedSeed::Reason::kWithoutDepth);
}

TEST(SeedsOffSupport, RemovesThoseOnItAndBelowItAsRead) {
  const std::vector<Seed> seeds = SeedsAt({{0, 0}, {1, 0}, {2, 0}}, Points()).seeds;
  PaperOptions options;
  std::vector<RemovedSeed> removed;
  EXPECT_EQ(SeedsOffSupport(kTable, seeds, options, removed).size(), 1U);
  ASSERT_EQ(removed.size(), 2U);
  EXPECT_EQ(removed[0].pixel, cv::Point(1, 0));
  EXPECT_EQ(removed[0].reason, RemovedSeed::Reason::kOnSupport);
  options.support_reading.removes_seeds_below = false;
  EXPECT_EQ(SeedsOffSupport(kTable, seeds, options, removed).size(), 2U);
  EXPECT_EQ(SeedsOffSupport(std::nullopt, seeds, options, removed).size(), 3U);
}

TEST(CertainBackground, IsTheSupportOnlyInTheHardReading) {
  VoxelGrid grid;
  grid.voxels = {{.mean = {0, 0, 0.95F}, .num_points = 1}, {.mean = {0, 0, 1}, .num_points = 1}};
  const std::vector<Support> supports = {{kTable, {}}};
  const CameraIntrinsics camera{500, 500, 320, 240};
  PaperOptions options;
  EXPECT_THAT(CertainBackground(grid, supports, camera, options), ElementsAre(0, 0));
  options.support_reading.hard = true;
  EXPECT_THAT(CertainBackground(grid, supports, camera, options), ElementsAre(0, 1));
  options.region.max_z_m = 0.9;
  EXPECT_THAT(CertainBackground(grid, supports, camera, options), ElementsAre(1, 1));
}

}  // namespace
}  // namespace fovea::paper
