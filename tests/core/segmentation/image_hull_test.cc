#include "core/segmentation/image_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

constexpr int kLeft = 1, kRight = 2;

// Two squares of 20 × 20 pixels, 20 pixels apart, on a tilted plane; `between` fills the rest.
struct Scene {
  explicit Scene(float between_m)
      : labels(cv::Mat::zeros(40, 80, CV_16UC1)), points(40, 80, CV_32FC3) {
    points.setTo(cv::Scalar(0, 0, between_m));
    for (const auto& [label, from] : {std::pair(kLeft, 10), std::pair(kRight, 50)}) {
      const cv::Rect square(from, 10, 20, 20);
      labels(square) = label;
      for (int x = square.x; x < square.br().x; ++x) {
        points(cv::Rect(x, square.y, 1, square.height)).setTo(cv::Scalar(0, 0, PlaneAt(x)));
      }
    }
  }

  // Depth of a plane seen under an angle: linear in 1/z.
  static double PlaneAt(int x) { return 1 / (1 + 0.002 * x); }

  double Share() const { return ShareSeenThrough(labels, points, kLeft, kRight); }

  cv::Mat labels, points;
};

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(ShareSeenThrough, BackgroundBetweenIsSeen) { EXPECT_EQ(Scene(2).Share(), 1); }

TEST(ShareSeenThrough, WhatIsInFrontOrNotMeasuredHides) {
  EXPECT_EQ(Scene(0.5).Share(), 0);
  EXPECT_EQ(Scene(kNone).Share(), 0);
}

TEST(ShareSeenThrough, TheSurfaceItselfIsNothingFartherAway) {
  Scene scene(2);
  for (int x = 0; x < 80; ++x) scene.points.col(x).setTo(cv::Scalar(0, 0, Scene::PlaneAt(x)));
  EXPECT_EQ(scene.Share(), 0);
}

TEST(ShareSeenThrough, CountsPixels) {
  Scene scene(2);
  scene.points(cv::Rect(30, 10, 20, 5)).setTo(cv::Scalar(0, 0, 0.5));
  EXPECT_DOUBLE_EQ(scene.Share(), 0.75);
}

TEST(ShareSeenThrough, NothingLiesBetweenPartsThatFillTheirHull) {
  Scene scene(2);
  scene.labels(cv::Rect(10, 10, 30, 20)) = kLeft;
  scene.labels(cv::Rect(40, 10, 30, 20)) = kRight;
  EXPECT_EQ(scene.Share(), 0);
}

}  // namespace
}  // namespace fovea
