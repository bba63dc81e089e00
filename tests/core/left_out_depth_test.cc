// Depth that the detector does not rely on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/detector.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea {
namespace {

using ::testing::Gt;
using ::testing::SizeIs;

scenes::LabelledFrame SeenTabletop(scenes::SensorKind sensor) {
  return scenes::MakeFrame(scenes::RandomScene("tabletop", 1, {320, 240}), sensor, 1);
}

// The last pixel of each object in a row is moved halfway to the background beside it: their depths
// where objects have points there.
std::vector<float> DepthsAtRims(const scenes::LabelledFrame& truth, double max_angle_deg) {
  RgbdFrame frame = truth.frame;
  frame.depth_m = truth.frame.depth_m.clone();
  std::vector<float> moved;
  for (int row = 0; row < frame.depth_m.rows; ++row) {
    const float* depth = truth.frame.depth_m.ptr<float>(row);
    const auto* label = truth.labels.ptr<std::uint16_t>(row);
    for (int col = 1; col + 1 < frame.depth_m.cols; ++col) {
      if (label[col] == 0 || label[col + 1] != 0 || depth[col + 1] - depth[col - 1] < 0.1F)
        continue;
      moved.push_back(0.5F * (depth[col - 1] + depth[col + 1]));
      frame.depth_m.at<float>(row, col) = moved.back();
    }
  }
  DetectorOptions options = OptionsOfProfile("default");
  options.flying_pixels.max_angle_deg = max_angle_deg;
  std::vector<float> found;
  for (const DetectedObject& object : Detect(frame, options).objects) {
    for (const ColoredPoint& point : object.cloud) {
      if (std::find(moved.begin(), moved.end(), point.z) != moved.end()) found.push_back(point.z);
    }
  }
  return found;
}

TEST(Detect, LeavesFlyingPixelsOut) {
  const scenes::LabelledFrame truth = SeenTabletop(scenes::SensorKind::kIdeal);
  EXPECT_THAT(DepthsAtRims(truth, 80), SizeIs(0));
  EXPECT_THAT(DepthsAtRims(truth, 90), SizeIs(Gt(0)));
}

TEST(Detect, WhatIsTooFarEndsAThingAsTheImageDoes) {
  const DetectorOptions options = OptionsOfProfile("default");
  const RgbdFrame whole = SeenTabletop(scenes::SensorKind::kKinect).frame;
  int middle = 0;  // column, of the rightmost object
  for (const DetectedObject& object : Detect(whole, options).objects) {
    middle = std::max(middle, object.bounds_px.x + object.bounds_px.width / 2);
  }
  const int cols = std::min(whole.depth_m.cols, middle + middle / 10);
  ASSERT_GT(cols, middle + 5);
  const float beyond = static_cast<float>(options.max_depth_m) + 1;
  for (const float depth : {std::numeric_limits<float>::quiet_NaN(), beyond}) {
    RgbdFrame frame = whole;
    frame.color_rgb = whole.color_rgb.colRange(0, cols).clone();
    frame.depth_m = whole.depth_m.colRange(0, cols).clone();
    frame.depth_m.colRange(middle, cols) = depth;
    const auto objects = Detect(frame, options).objects;
    EXPECT_TRUE(std::any_of(objects.begin(), objects.end(), [&](const DetectedObject& object) {
      return object.truncated && object.bounds_px.br().x > middle - 5;
    })) << depth;
  }
}

// A table seen from 0.6 m above it, 40 degrees below the horizon.
RgbdFrame Table() {
  RgbdFrame frame{cv::Mat(240, 320, CV_8UC3, cv::Scalar(150, 120, 90)),
                  cv::Mat(240, 320, CV_32FC1),
                  {260, 260, 160, 120},
                  std::nullopt};
  const double pitch = 40 * std::numbers::pi / 180;
  frame.gravity =
      Eigen::Vector3f(0, static_cast<float>(std::cos(pitch)), static_cast<float>(std::sin(pitch)));
  for (int row = 0; row < 240; ++row) {
    const double down = std::cos(pitch) * (row - 120) / 260 + std::sin(pitch);
    frame.depth_m.row(row) = static_cast<float>(0.6 / down);
  }
  return frame;
}

// The highest cell of its height map.
double HighestCell(const RgbdFrame& frame, const DetectorOptions& options, Detections& found) {
  found = Detect(frame, options);
  cv::Mat heights_m = found.height_map.value().heights_m.clone();
  cv::patchNaNs(heights_m, -1);
  double highest = 0;
  cv::minMaxLoc(heights_m, nullptr, &highest);
  return highest;
}

TEST(Detect, TakesWhatNoCameraMeasuresForMissingDepth) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  DetectorOptions options = OptionsOfProfile("default");
  options.choice.min_probability = 0;
  for (const float none : {std::nanf(""), 0.0F, -1.0F, 1e-4F, 2e4F, kInfinite}) {
    RgbdFrame frame = Table();
    const cv::Rect mat(120, 90, 80, 50);
    frame.color_rgb(mat).setTo(cv::Scalar::all(20));
    frame.depth_m(mat).setTo(none);
    const auto objects = Detect(frame, options).objects;
    ASSERT_THAT(objects, SizeIs(1)) << none;
    EXPECT_TRUE(objects[0].depth_missing) << none;
  }
}

// Whether it is taken for a thing or not decides what planners are told of it.
TEST(Detect, HeightMapsHaveWhatStandsInForMissingDepthOnlyWhereItIsAnObject) {
  RgbdFrame frame = Table();
  const cv::Rect mat(120, 90, 80, 50);
  frame.color_rgb(mat).setTo(cv::Scalar::all(20));
  frame.depth_m(mat).setTo(std::numeric_limits<float>::quiet_NaN());
  DetectorOptions options = OptionsOfProfile("default");
  options.planning.height_map = true;
  Detections found;
  options.choice.min_probability = 0;
  EXPECT_GT(HighestCell(frame, options, found), 0.05);
  EXPECT_THAT(found.objects, SizeIs(1));
  options.choice.min_probability = 1;
  EXPECT_LT(HighestCell(frame, options, found), 0.01);
  EXPECT_THAT(found.objects, SizeIs(0));
}

}  // namespace
}  // namespace fovea
