#include "core/depth/flying_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

namespace fovea {
namespace {

constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();
constexpr double kFocalLength_px = 525;  // at 80° and 1 m a pixel may rise by 11 mm

cv::Mat Remove(const cv::Mat& depth_m, double max_angle_deg = 80) {
  return RemoveFlyingPixels(depth_m, kFocalLength_px, kFocalLength_px,
                            {.max_angle_deg = max_angle_deg});
}

// The columns that have no depth any more.
std::vector<int> Removed(const std::vector<float>& row) {
  const cv::Mat depth_m = cv::Mat(row, true).reshape(1, 1);
  const cv::Mat kept = Remove(depth_m);
  std::vector<int> removed;
  for (int col = 0; col < depth_m.cols; ++col) {
    if (std::isnan(kept.at<float>(col)) && !std::isnan(row[col])) removed.push_back(col);
  }
  return removed;
}

TEST(RemoveFlyingPixels, RemovesWhatLiesBetweenTwoSurfaces) {
  EXPECT_EQ(Removed({1.0F, 1.0F, 1.05F, 1.1F, 1.1F}), std::vector<int>({2}));
  EXPECT_EQ(Removed({1.1F, 1.1F, 1.07F, 1.03F, 1.0F, 1.0F}), std::vector<int>({2, 3}));
}

TEST(RemoveFlyingPixels, RemovesAlongColumnsToo) {
  const cv::Mat column = (cv::Mat_<float>(5, 1) << 1.0F, 1.0F, 1.05F, 1.1F, 1.1F);
  const cv::Mat kept = Remove(column);
  EXPECT_TRUE(std::isnan(kept.at<float>(2)));
  EXPECT_EQ(cv::countNonZero(kept == kept), 4);
}

TEST(RemoveFlyingPixels, KeepsBothSidesOfACleanStep) {
  EXPECT_TRUE(Removed({1.0F, 1.0F, 1.1F, 1.1F}).empty());
}

TEST(RemoveFlyingPixels, KeepsSlopesThatACameraSees) {
  EXPECT_TRUE(Removed({1.0F, 1.01F, 1.02F, 1.03F, 1.04F}).empty());
}

TEST(RemoveFlyingPixels, KeepsThinThingsAndSpikes) {
  EXPECT_TRUE(Removed({1.1F, 1.1F, 1.0F, 1.1F, 1.1F}).empty());
  EXPECT_TRUE(Removed({1.0F, 1.0F, 1.1F, 1.0F, 1.0F}).empty());
}

TEST(RemoveFlyingPixels, KeepsPixelsBesideAHoleOrTheBorder) {
  EXPECT_TRUE(Removed({1.0F, 1.05F, kNoDepth, 1.15F, 1.2F}).empty());
}

TEST(RemoveFlyingPixels, ComparesFartherApartInLargerImages) {
  // Six pixels of slope in an image three times as wide: the same surfaces as two at 640.
  cv::Mat depth_m(1, 1920, CV_32FC1, cv::Scalar(1.0));
  for (int i = 1; i <= 6; ++i) depth_m.at<float>(960 + i) = 1.0F + 0.01F * static_cast<float>(i);
  depth_m.colRange(967, 1920).setTo(1.06);
  const cv::Mat kept =
      RemoveFlyingPixels(depth_m, 3 * kFocalLength_px, 3 * kFocalLength_px, {.max_angle_deg = 80});
  EXPECT_TRUE(std::isnan(kept.at<float>(963)));
  EXPECT_FALSE(std::isnan(kept.at<float>(950)));
  EXPECT_FALSE(std::isnan(kept.at<float>(975)));
}

TEST(RemoveFlyingPixels, RemovesNothingAtNinetyDegrees) {
  const cv::Mat depth_m = (cv::Mat_<float>(1, 3) << 1.0F, 1.5F, 2.0F);
  EXPECT_EQ(cv::countNonZero(Remove(depth_m, 90) != depth_m), 0);
}

}  // namespace
}  // namespace fovea
