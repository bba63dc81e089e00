#include "core/depth/seen_area.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace fovea {
namespace {

// 64 × 48 pixels with depth in `measured` only.
cv::Mat PointsIn(const cv::Rect& measured) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  cv::Mat points(48, 64, CV_32FC3, cv::Scalar(none, none, none));
  points(measured).setTo(cv::Scalar(0, 0, 1));
  return points;
}

cv::Rect BoundsOf(const cv::Mat& points) { return SeenArea(points, {}).bounds(); }

TEST(SeenArea, LeavesOutMargins) {
  const cv::Rect measured(2, 3, 57, 44);
  EXPECT_EQ(BoundsOf(PointsIn(measured)), measured);
  EXPECT_EQ(BoundsOf(PointsIn({0, 0, 64, 48})), cv::Rect(0, 0, 64, 48));
}

TEST(SeenArea, WhatIsWiderThanAnEighthIsNoMargin) {
  EXPECT_EQ(BoundsOf(PointsIn({0, 6, 55, 42})), cv::Rect(0, 0, 64, 48));
}

TEST(SeenArea, LinesOfWhichHalfIsMeasuredCount) {
  cv::Mat points = PointsIn({4, 0, 60, 48});
  points(cv::Rect(2, 0, 2, 24)).setTo(cv::Scalar(0, 0, 1));  // half of two columns
  points(cv::Rect(1, 0, 1, 23)).setTo(cv::Scalar(0, 0, 1));  // less than half
  EXPECT_EQ(BoundsOf(points), cv::Rect(2, 0, 62, 48));
}

// The pixels of a rectangle.
PixelRuns Mask(const cv::Rect& rect) {
  PixelRuns pixels;
  for (int row = rect.y; row < rect.br().y; ++row) pixels.push_back({row, rect.x, rect.br().x});
  return pixels;
}

cv::Mat PointsOfImage(const cv::Rect& measured) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  cv::Mat points(480, 640, CV_32FC3, cv::Scalar(none, none, none));
  points(measured).setTo(cv::Scalar(0, 0, 1));
  return points;
}

TEST(SeenArea, CutsOffAtTheEndOfTheImageOrNearAMargin) {
  const SeenArea whole(PointsOfImage({0, 0, 640, 480}), {});
  const SeenArea with_margin(PointsOfImage({8, 0, 632, 480}), {});
  EXPECT_TRUE(whole.CutsOff(Mask({0, 100, 50, 50})));
  EXPECT_TRUE(whole.CutsOff(Mask({590, 100, 50, 50})));
  EXPECT_TRUE(with_margin.CutsOff(Mask({100, 430, 50, 50})));
  EXPECT_FALSE(whole.CutsOff(Mask({2, 100, 50, 50})));
  EXPECT_TRUE(with_margin.CutsOff(Mask({14, 100, 50, 50})));
  EXPECT_FALSE(with_margin.CutsOff(Mask({15, 100, 50, 50})));
}

// A curved edge: all of the image within 300 px of its middle.
TEST(SeenArea, CutsOffWhereTheCameraDoesNotLook) {
  cv::Mat unseen(480, 640, CV_8UC1, cv::Scalar(255));
  cv::circle(unseen, {320, 240}, 300, cv::Scalar(0), cv::FILLED);
  const SeenArea area(PointsOfImage({0, 0, 640, 480}), unseen);
  EXPECT_TRUE(area.CutsOff(Mask({72, 72, 40, 40})));     // its corner is 299 px away
  EXPECT_FALSE(area.CutsOff(Mask({150, 150, 40, 40})));  // 197 px
  EXPECT_TRUE(area.Contains({320, 0}));
  EXPECT_FALSE(area.Contains({60, 60}));
  EXPECT_FALSE(area.Contains({-1, 240}));
}

}  // namespace
}  // namespace fovea
