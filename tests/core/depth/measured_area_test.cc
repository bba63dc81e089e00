#include "core/depth/measured_area.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

// 64 × 48 pixels with depth in `measured` only.
cv::Mat PointsIn(const cv::Rect& measured) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  cv::Mat points(48, 64, CV_32FC3, cv::Scalar(none, none, none));
  points(measured).setTo(cv::Scalar(0, 0, 1));
  return points;
}

TEST(MeasuredArea, LeavesOutMargins) {
  const cv::Rect measured(2, 3, 57, 44);
  EXPECT_EQ(MeasuredArea(PointsIn(measured)), measured);
  EXPECT_EQ(MeasuredArea(PointsIn({0, 0, 64, 48})), cv::Rect(0, 0, 64, 48));
}

TEST(MeasuredArea, WhatIsWiderThanAnEighthIsNoMargin) {
  EXPECT_EQ(MeasuredArea(PointsIn({0, 6, 55, 42})), cv::Rect(0, 0, 64, 48));
}

TEST(MeasuredArea, LinesOfWhichHalfIsMeasuredCount) {
  cv::Mat points = PointsIn({4, 0, 60, 48});
  points(cv::Rect(2, 0, 2, 24)).setTo(cv::Scalar(0, 0, 1));  // half of two columns
  points(cv::Rect(1, 0, 1, 23)).setTo(cv::Scalar(0, 0, 1));  // less than half
  EXPECT_EQ(MeasuredArea(points), cv::Rect(2, 0, 62, 48));
}

TEST(EndsWithArea, AtTheEndOfTheImageOrNearAMargin) {
  const cv::Size image(640, 480);
  const cv::Rect whole({}, image), with_margin(8, 0, 632, 480);
  EXPECT_TRUE(EndsWithArea({0, 100, 50, 50}, whole, image));
  EXPECT_TRUE(EndsWithArea({590, 100, 50, 50}, whole, image));
  EXPECT_TRUE(EndsWithArea({100, 430, 50, 50}, with_margin, image));
  EXPECT_FALSE(EndsWithArea({2, 100, 50, 50}, whole, image));
  EXPECT_TRUE(EndsWithArea({14, 100, 50, 50}, with_margin, image));
  EXPECT_FALSE(EndsWithArea({15, 100, 50, 50}, with_margin, image));
}

}  // namespace
}  // namespace fovea
