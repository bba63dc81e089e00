#include "tests/evaluation/camera_effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace fovea::evaluation {
namespace {

// A box at 0.8 m before a wall at 1 m, in two colours, with a strip without depth at the left.
RgbdFrame BoxBeforeAWall() {
  RgbdFrame frame{cv::Mat(120, 160, CV_8UC3, cv::Scalar(200, 100, 50)),
                  cv::Mat(120, 160, CV_32FC1, cv::Scalar(1.002)),
                  {130, 130, 79.5, 59.5},
                  std::nullopt};
  const cv::Rect box(61, 41, 40, 40);
  frame.color_rgb(box).setTo(cv::Scalar(20, 40, 220));
  frame.depth_m(box) = 0.8F;
  frame.depth_m.colRange(0, 8) = std::numeric_limits<float>::quiet_NaN();
  return frame;
}

bool AreEqual(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat a_numbers = a.clone(), b_numbers = b.clone();
  cv::patchNaNs(a_numbers, -1);
  cv::patchNaNs(b_numbers, -1);
  return cv::norm(a_numbers, b_numbers, cv::NORM_INF) == 0;
}

int CountMeasured(const RgbdFrame& frame) {
  return cv::countNonZero(frame.depth_m == frame.depth_m);
}

std::vector<std::string> EffectNames() {
  std::vector<std::string> names;
  for (const CameraEffect& effect : CameraEffects()) names.push_back(effect.name);
  return names;
}

class EachCameraEffect : public testing::TestWithParam<std::string> {};

TEST_P(EachCameraEffect, ChangesTheFrameTheSameEveryTimeAndInventsNoDepth) {
  const RgbdFrame frame = BoxBeforeAWall();
  const RgbdFrame once = WithCameraEffect(frame, GetParam(), 7);
  const RgbdFrame again = WithCameraEffect(frame, GetParam(), 7);
  EXPECT_TRUE(AreEqual(once.depth_m, again.depth_m));
  EXPECT_EQ(cv::norm(once.color_rgb, again.color_rgb, cv::NORM_INF), 0);
  EXPECT_FALSE(AreEqual(once.depth_m, frame.depth_m) &&
               cv::norm(once.color_rgb, frame.color_rgb, cv::NORM_INF) == 0);
  EXPECT_LE(CountMeasured(once), CountMeasured(frame));
  EXPECT_GT(CountMeasured(once), CountMeasured(frame) / 2);
  EXPECT_TRUE(AreEqual(frame.depth_m, BoxBeforeAWall().depth_m)) << "changed its input";
}

INSTANTIATE_TEST_SUITE_P(All, EachCameraEffect, testing::ValuesIn(EffectNames()),
                         [](const auto& tested) { return tested.param; });

TEST(CameraEffects, FlyingPixelsLieBetweenTheSurfaces) {
  const RgbdFrame flying = WithCameraEffect(BoxBeforeAWall(), "flying_pixels", 0);
  const float edge = flying.depth_m.at<float>(60, 61);  // the box's first column
  EXPECT_GT(edge, 0.85F);
  EXPECT_LT(edge, 0.95F);
  EXPECT_FLOAT_EQ(flying.depth_m.at<float>(60, 80), 0.8F);
}

TEST(CameraEffects, WhiteNoiseHasItsDeviation) {
  const RgbdFrame frame = BoxBeforeAWall();
  const cv::Rect wall(10, 0, 40, 120);
  cv::Scalar mean, deviation;
  cv::meanStdDev(WithCameraEffect(frame, "white_noise", 3).depth_m(wall), mean, deviation);
  EXPECT_NEAR(mean[0], 1.002, 3 * 0.003 / std::sqrt(wall.area()));
  EXPECT_NEAR(deviation[0], 0.003, 0.0002);
}

TEST(CameraEffects, CoarseStepsAreFiveMillimetres) {
  const RgbdFrame coarse = WithCameraEffect(BoxBeforeAWall(), "coarse_steps", 0);
  EXPECT_NEAR(coarse.depth_m.at<float>(0, 20), 1.0F, 1e-6);
}

TEST(CameraEffects, NamesAnEffectThatDoesNotExist) {
  try {
    WithCameraEffect(BoxBeforeAWall(), "fog", 0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "fog: no such camera effect");
  }
}

}  // namespace
}  // namespace fovea::evaluation
