#include "core/seeds/saliency_seeds.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgproc.hpp>

namespace fovea {
namespace {

constexpr auto kColor = Seed::Source::kColorSaliency;

cv::Mat FlatPoints(const cv::Size& size) {
  cv::Mat points(size, CV_32FC3);
  for (int row = 0; row < size.height; ++row) {
    for (int col = 0; col < size.width; ++col) {
      points.at<cv::Vec3f>(row, col) = {static_cast<float>(col), static_cast<float>(row), 1};
    }
  }
  return points;
}

// 640 wide, so that the disk has the radius given.
cv::Mat MapWithDisk(const cv::Point& center, int radius) {
  cv::Mat map(200, 640, CV_32FC1, cv::Scalar(0.1F));
  cv::circle(map, center, radius, cv::Scalar(0.9F), cv::FILLED);
  return map;
}

TEST(FindSeeds, FindsTheCenterOfAPeakLargerThanTheDisk) {
  const cv::Mat map = MapWithDisk({300, 100}, 30);
  const auto found = FindSeeds(map, FlatPoints(map.size()), kColor, {.disk_radius_px = 20});
  ASSERT_EQ(found.seeds.size(), 1U);
  EXPECT_EQ(found.seeds[0].pixel, cv::Point(300, 100));
  EXPECT_EQ(found.seeds[0].position, Eigen::Vector3f(300, 100, 1));
  EXPECT_EQ(found.seeds[0].source, kColor);
}

TEST(FindSeeds, FlattensPeaksSmallerThanTheDisk) {
  const cv::Mat map = MapWithDisk({300, 100}, 15);
  const cv::Mat points = FlatPoints(map.size());
  EXPECT_TRUE(FindSeeds(map, points, kColor, {.disk_radius_px = 20}).seeds.empty());
  EXPECT_EQ(FindSeeds(map, points, kColor, {.disk_radius_px = 10}).seeds.size(), 1U);
}

TEST(FindSeeds, MovesToTheNearestMeasuredPixelOfThePeakIfAsked) {
  const cv::Mat map = MapWithDisk({300, 100}, 30);
  cv::Mat points = FlatPoints(map.size());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  points.colRange(0, 310).setTo(cv::Scalar::all(nan));
  const auto moved = FindSeeds(map, points, kColor, {.on_peak = true});
  ASSERT_EQ(moved.seeds.size(), 1U);
  EXPECT_EQ(moved.seeds[0].pixel, cv::Point(310, 100));
  const auto lost = FindSeeds(map, points, kColor, {.on_peak = false});
  EXPECT_TRUE(lost.seeds.empty());
  EXPECT_EQ(lost.without_depth.size(), 1U);
}

TEST(FindSeeds, ScalesTheDiskWithTheWidth) {
  cv::Mat map;
  cv::resize(MapWithDisk({300, 100}, 15), map, {}, 0.5, 0.5, cv::INTER_NEAREST);
  const cv::Mat points = FlatPoints(map.size());
  EXPECT_EQ(FindSeeds(map, points, kColor, {.disk_radius_px = 10}).seeds.size(), 1U);
  EXPECT_TRUE(FindSeeds(map, points, kColor, {.disk_radius_px = 20}).seeds.empty());
}

TEST(FindSeeds, FindsTheSameInAMapOfBlocksWhenToldOfThem) {
  const cv::Size size(637, 198);  // no multiple of a block
  cv::Mat small(size.height / 4 + 1, size.width / 4 + 1, CV_8UC1), map;
  cv::RNG(3).fill(small, cv::RNG::UNIFORM, 0, 12);
  cv::GaussianBlur(small, small, {5, 5}, 0);
  cv::resize(small, map, small.size() * 4, 0, 0, cv::INTER_NEAREST);
  map(cv::Rect({}, size)).convertTo(map, CV_32F);
  for (const double radius_px : {3.0, 5.0, 20.0}) {
    const auto all = FindSeeds(map, FlatPoints(size), kColor, {.disk_radius_px = radius_px});
    const auto blocks = FindSeeds(map, FlatPoints(size), kColor, {.disk_radius_px = radius_px}, 4);
    ASSERT_EQ(blocks.seeds.size(), all.seeds.size());
    EXPECT_GE(all.seeds.size(), radius_px < 10 ? 4U : 0U);
    for (std::size_t i = 0; i < all.seeds.size(); ++i) {
      EXPECT_EQ(blocks.seeds[i].pixel, all.seeds[i].pixel);
    }
  }
}

TEST(FindSeeds, FindsNothingInAConstantMap) {
  const cv::Mat map(50, 640, CV_32FC1, cv::Scalar(0.5F));
  const auto found = FindSeeds(map, FlatPoints(map.size()), kColor);
  EXPECT_TRUE(found.seeds.empty());
  EXPECT_TRUE(found.without_depth.empty());
}

}  // namespace
}  // namespace fovea
