#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <utility>

#include "core/detector.h"

namespace fovea {
namespace {

const cv::Size kSize(320, 240);
constexpr CameraIntrinsics kCamera{300, 300, 159.5, 119.5};

// What lies on a table, red on grey, seen by a camera above it that looks down by `pitch_deg`.
struct Slab {
  cv::Rect at;
  double thickness_m = 0.06;
  double camera_m = 0.7;
  double pitch_deg = 90;
};

RgbdFrame FrameOf(const Slab& slab) {
  constexpr double kNoise_m = 0.0005;
  RgbdFrame frame;
  frame.intrinsics = kCamera;
  frame.color_rgb = cv::Mat(kSize, CV_8UC3, cv::Scalar::all(180));
  frame.color_rgb(slab.at).setTo(cv::Scalar(200, 20, 20));
  frame.depth_m.create(kSize, CV_32FC1);
  const double pitch_rad = slab.pitch_deg * CV_PI / 180;
  cv::RNG noise(1);
  for (int row = 0; row < kSize.height; ++row) {
    const double y = (row - kCamera.cy_px) / kCamera.fy_px;
    const double down = y * std::cos(pitch_rad) + std::sin(pitch_rad);
    for (int col = 0; col < kSize.width; ++col) {
      const double height_m = slab.camera_m - (slab.at.contains({col, row}) ? slab.thickness_m : 0);
      frame.depth_m.at<float>(row, col) =
          static_cast<float>(height_m / down + noise.gaussian(kNoise_m));
    }
  }
  return frame;
}

// What is thinner than its depth tells is known by its colour alone.
TEST(ImageEdge, AFlatThingAtTheFirstColumnIsFound) {
  const RgbdFrame frame = FrameOf({.at = {0, 90, 40, 60}, .thickness_m = 0.0015, .pitch_deg = 50});
  const Detections found = Detect(frame, OptionsOfProfile("default"));
  ASSERT_THAT(found.objects, testing::SizeIs(1));
  EXPECT_TRUE(found.objects[0].truncated);
  EXPECT_EQ(found.objects[0].bounds_px.x, 0);
}

class EachProfile : public testing::TestWithParam<std::string> {
 protected:
  Detections Find(const RgbdFrame& frame) const {
    return Detect(frame, OptionsOfProfile(GetParam()));
  }

  // Labelled pixels along the first column (flip_code 1) or row (0), and along the last one of the
  // same frame in a mirror.
  std::pair<int, int> AlongTheEdge(const RgbdFrame& frame, int flip_code) const {
    RgbdFrame mirrored = frame;  // its principal point is in the middle
    cv::flip(frame.color_rgb, mirrored.color_rgb = cv::Mat(), flip_code);
    cv::flip(frame.depth_m, mirrored.depth_m = cv::Mat(), flip_code);
    const cv::Mat first = Find(frame).labels, last = Find(mirrored).labels;
    if (flip_code == 0) return {cv::countNonZero(first.row(0)), cv::countNonZero(last.row(239))};
    return {cv::countNonZero(first.col(0)), cv::countNonZero(last.col(319))};
  }
};

TEST_P(EachProfile, FindsAsMuchAtTheFirstColumnAndRowAsAtTheLast) {
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    const double camera_m = 0.6 + 0.02 * i;
    const auto [left, right] =
        AlongTheEdge(FrameOf({.at = {0, 80, 50 + i, 80}, .camera_m = camera_m}), 1);
    EXPECT_EQ(left, right);
    const auto [top, bottom] =
        AlongTheEdge(FrameOf({.at = {100, 0, 80, 50 + i}, .camera_m = camera_m}), 0);
    EXPECT_EQ(top, bottom);
  }
}

INSTANTIATE_TEST_SUITE_P(ImageEdge, EachProfile, testing::Values("default", "paper"));

}  // namespace
}  // namespace fovea
