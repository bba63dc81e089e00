#include "core/objects/seclusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

// A segment of 40×40 pixels, 1 m away, before a background at 2 m.
struct Scene {
  cv::Mat labels = cv::Mat::zeros(480, 640, CV_16UC1);
  cv::Mat depth_m = cv::Mat(480, 640, CV_32FC1, cv::Scalar(2));
  std::vector<cv::Point> pixels;

  Scene() {
    const cv::Rect segment(300, 200, 40, 40);
    labels(segment).setTo(1);
    depth_m(segment).setTo(1);
    for (int row = segment.y; row < segment.br().y; ++row) {
      for (int col = segment.x; col < segment.br().x; ++col) pixels.emplace_back(col, row);
    }
  }
  Seclusion Find() const { return FindSeclusion(labels, depth_m, pixels); }
};

TEST(FindSeclusion, IsNoneInTheOpen) {
  const Seclusion seclusion = Scene().Find();
  EXPECT_EQ(seclusion.hidden, 0);
  EXPECT_EQ(seclusion.level, 0);
}

TEST(FindSeclusion, CountsSidesAtSomethingNearer) {
  Scene scene;
  scene.labels.colRange(340, 400).setTo(2);
  scene.depth_m.colRange(340, 400).setTo(0.8F);
  EXPECT_DOUBLE_EQ(scene.Find().hidden, 0.25);
}

TEST(FindSeclusion, LooksAcrossTheShadowOfSomethingNearer) {
  Scene scene;
  scene.depth_m.colRange(340, 360).setTo(std::nanf(""));
  EXPECT_EQ(scene.Find().hidden, 0);
  scene.depth_m.colRange(360, 400).setTo(0.8F);
  EXPECT_DOUBLE_EQ(scene.Find().hidden, 0.25);
}

TEST(FindSeclusion, CountsSidesThatGoOnAtTheSameDistance) {
  Scene scene;
  scene.depth_m.rowRange(240, 300).setTo(1.01F);  // less than noise at 1 m
  EXPECT_DOUBLE_EQ(scene.Find().level, 0.25);
  EXPECT_EQ(scene.Find().hidden, 0);
}

TEST(FindSeclusion, DoesNotCountHolesWithinTheSegment) {
  Scene scene;
  scene.labels(cv::Rect(310, 210, 10, 10)).setTo(0);
  scene.depth_m(cv::Rect(310, 210, 10, 10)).setTo(std::nanf(""));
  const Seclusion seclusion = scene.Find();
  EXPECT_EQ(seclusion.hidden, 0);
  EXPECT_EQ(seclusion.level, 0);
}

TEST(FindSeclusion, TakesTheEndOfTheImageForOpen) {
  Scene scene;
  scene.labels = scene.labels(cv::Rect(300, 200, 340, 280)).clone();
  scene.depth_m = scene.depth_m(cv::Rect(300, 200, 340, 280)).clone();
  for (cv::Point& pixel : scene.pixels) pixel -= cv::Point(300, 200);
  EXPECT_EQ(scene.Find().hidden, 0);
  EXPECT_EQ(scene.Find().level, 0);
}

}  // namespace
}  // namespace fovea
