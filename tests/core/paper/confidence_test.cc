#include "core/paper/confidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace fovea::paper {
namespace {

TEST(Confidence, GrowsWithTheAreaUntilThereIsAmple) {
  EXPECT_LT(Confidence(0.001, 1), Confidence(0.002, 1));
  EXPECT_LT(Confidence(0.002, 1), Confidence(0.005, 1));
  EXPECT_EQ(Confidence(0.005, 1), Confidence(0.5, 1));
}

TEST(Confidence, FallsWithTheDistanceBeyondAMetre) {
  EXPECT_EQ(Confidence(0.01, 0.3), Confidence(0.01, 1));
  EXPECT_GT(Confidence(0.01, 1), Confidence(0.01, 2));
  EXPECT_GT(Confidence(0.01, 2), Confidence(0.01, 3));
}

double LogOdds(double probability) { return std::log(probability / (1 - probability)); }

// As fitted: the odds of what is ample and near, and what they lose with area and distance.
TEST(Confidence, HasTheSlopesOfItsFit) {
  const double ample = LogOdds(Confidence(0.005, 1));
  EXPECT_NEAR(ample, 3.5, 1e-3);
  EXPECT_NEAR(LogOdds(Confidence(0.0025, 1)) - ample, -2.53 * std::log(2), 1e-3);
  EXPECT_NEAR(LogOdds(Confidence(0.005, 3)) - ample, -0.71 * 2, 1e-3);
}

TEST(Confidence, IsAProbabilityForAnyInput) {
  for (const double area : {0.0, 1e-300, 1e-4, 1.0, 1e300}) {
    for (const double distance : {0.0, 1.0, 100.0, std::numeric_limits<double>::infinity()}) {
      EXPECT_GE(Confidence(area, distance), 0);
      EXPECT_LT(Confidence(area, distance), 1);
    }
  }
}

// 2000 pixels at 1 m, and half of them at 2 m.
TEST(Confidences, KnowAreaAndDistanceOfEachSegment) {
  const CameraIntrinsics intrinsics{.fx_px = 500, .fy_px = 400, .cx_px = 320, .cy_px = 240};
  cv::Mat labels = cv::Mat::zeros(480, 640, CV_16UC1);
  cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(1));
  labels(cv::Rect(200, 200, 20, 20)) = 1;
  labels(cv::Rect(100, 100, 40, 50)) = 3;
  EXPECT_EQ(Confidences(labels, depth_m, intrinsics),
            (std::vector<float>{Confidence(0.002, 1), 0, Confidence(0.01, 1)}));
  depth_m(cv::Rect(100, 100, 20, 50)) = 2;
  EXPECT_FLOAT_EQ(Confidences(labels, depth_m, intrinsics)[2],
                  Confidence(0.025, std::sqrt(2.5)));  // root of the mean square
  EXPECT_TRUE(Confidences(cv::Mat::zeros(480, 640, CV_16UC1), depth_m, intrinsics).empty());
}

}  // namespace
}  // namespace fovea::paper
