#include "core/paper/superpixels.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace fovea::paper {
namespace {

TEST(DivideIntoSuperpixels, DividesAConstantMapIntoAGrid) {
  const cv::Mat map(40, 60, CV_32F, cv::Scalar(2));
  const Superpixels superpixels = DivideIntoSuperpixels(map, 24, 1.0F);
  ASSERT_EQ(superpixels.all.size(), 24U);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      ASSERT_EQ(superpixels.labels.at<int>(y, x), y / 10 * 6 + x / 10);
    }
  }
  const Superpixel& last = superpixels.all.back();
  EXPECT_EQ(last.pixels, 100);
  EXPECT_FLOAT_EQ(last.x_px, 54.5F);
  EXPECT_FLOAT_EQ(last.y_px, 34.5F);
  EXPECT_FLOAT_EQ(last.value, 2.0F);
}

TEST(DivideIntoSuperpixels, FollowsAStepBetweenTheGridLines) {
  cv::Mat map = cv::Mat::zeros(40, 60, CV_32F);
  map.colRange(26, 60) = 100.0F;
  const Superpixels superpixels = DivideIntoSuperpixels(map, 24, 1.0F);
  for (int y = 0; y < map.rows; ++y) {
    EXPECT_NE(superpixels.labels.at<int>(y, 25), superpixels.labels.at<int>(y, 26));
  }
  for (const Superpixel& superpixel : superpixels.all) {
    EXPECT_TRUE(superpixel.pixels == 0 || superpixel.value == 0 || superpixel.value == 100);
  }
}

TEST(DivideIntoSuperpixels, LeavesPixelsWithoutAValueOut) {
  cv::Mat map(30, 30, CV_32F, cv::Scalar(1));
  map(cv::Rect(0, 0, 10, 30)) = std::numeric_limits<float>::infinity();
  map.at<float>(15, 20) = std::numeric_limits<float>::quiet_NaN();
  const Superpixels superpixels = DivideIntoSuperpixels(map, 9, 1.0F);
  EXPECT_EQ(cv::countNonZero(superpixels.labels == -1), 301);
  EXPECT_EQ(superpixels.labels.at<int>(15, 20), -1);
  EXPECT_EQ(superpixels.all[0].pixels, 0);
}

TEST(DivideIntoSuperpixels, TakesMoreSuperpixelsThanPixels) {
  const cv::Mat map(2, 3, CV_32F, cv::Scalar(1));
  EXPECT_EQ(cv::countNonZero(DivideIntoSuperpixels(map, 100, 1.0F).labels < 0), 0);
}

}  // namespace
}  // namespace fovea::paper
