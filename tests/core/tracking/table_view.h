// A wall with random texture 1 m before the camera, and things before it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <random>

#include "core/tracking/tracker.h"

namespace fovea::testing {

constexpr CameraIntrinsics kIntrinsics = {250, 250, 159.5, 119.5};
const cv::Size kSize(320, 240);
constexpr std::array<std::uint8_t, 3> kRed = {200, 30, 30}, kBlue = {30, 30, 200};

// The camera stands at (x_m, 0, 0) and looks along z. Noise of the sensor by `seed`.
inline RgbdFrame WallFrame(double x_m = 0, std::uint64_t seed = 0) {
  static const cv::Mat texture = [] {
    cv::Mat noise(kSize.height, 4 * kSize.width, CV_8UC1), smooth;
    std::mt19937_64 random(5);
    for (auto it = noise.begin<std::uint8_t>(); it != noise.end<std::uint8_t>(); ++it) {
      *it = static_cast<std::uint8_t>(random() % 256);
    }
    cv::GaussianBlur(noise, smooth, {9, 9}, 2);
    smooth.convertTo(smooth, CV_8UC1, 4, -384);
    return smooth;
  }();
  RgbdFrame frame;
  const int shift_px = cvRound(x_m * kIntrinsics.fx_px);
  cv::cvtColor(texture({{kSize.width + shift_px, 0}, kSize}), frame.color_rgb, cv::COLOR_GRAY2RGB);
  std::mt19937_64 random(seed);
  for (auto it = frame.color_rgb.begin<cv::Vec3b>(); it != frame.color_rgb.end<cv::Vec3b>(); ++it) {
    const int noise = static_cast<int>(random() % 5) - 2;
    for (int c = 0; c < 3; ++c) (*it)[c] = cv::saturate_cast<std::uint8_t>((*it)[c] + noise);
  }
  frame.depth_m = cv::Mat(kSize, CV_32FC1, cv::Scalar(1));
  frame.intrinsics = kIntrinsics;
  return frame;
}

// A picture to track in. Things are square plates that face the camera.
struct View {
  explicit View(double x_m = 0, std::uint64_t seed = 0) : frame(WallFrame(x_m, seed)), camera(x_m) {
    detections.labels = cv::Mat::zeros(kSize, CV_16UC1);
  }

  // `center`: in the frame in which the camera is at (x_m, 0, 0).
  View& Add(const Eigen::Vector3f& center, std::array<std::uint8_t, 3> color = {200, 30, 30},
            float side_m = 0.1F, float confidence = 0.9F) {
    const Eigen::Vector3f at = center - Eigen::Vector3f(static_cast<float>(camera), 0, 0);
    DetectedObject object;
    object.label = static_cast<int>(detections.objects.size()) + 1;
    object.confidence = confidence;
    object.mean_color = color;
    object.centroid = object.box.center = at;
    object.box.size_m = {side_m, side_m, side_m};
    const auto px = [&](double sign, float x, double c) {
      return cvRound(c + kIntrinsics.fx_px * (x + sign * side_m / 2) / at.z());
    };
    const cv::Rect plate(
        cv::Point(px(-1, at.x(), kIntrinsics.cx_px), px(-1, at.y(), kIntrinsics.cy_px)),
        cv::Point(px(1, at.x(), kIntrinsics.cx_px), px(1, at.y(), kIntrinsics.cy_px)));
    object.bounds_px = plate & cv::Rect({0, 0}, kSize);
    object.num_pixels = object.bounds_px.area();
    detections.labels(object.bounds_px).setTo(object.label);
    frame.depth_m(object.bounds_px).setTo(at.z());
    frame.color_rgb(object.bounds_px).setTo(cv::Scalar(color[0], color[1], color[2]));
    for (int y = object.bounds_px.y; y < object.bounds_px.br().y; ++y) {
      for (int x = object.bounds_px.x; x < object.bounds_px.br().x; ++x) {
        object.cloud.push_back(
            {static_cast<float>((x - kIntrinsics.cx_px) / kIntrinsics.fx_px) * at.z(),
             static_cast<float>((y - kIntrinsics.cy_px) / kIntrinsics.fy_px) * at.z(), at.z(),
             color[0], color[1], color[2]});
      }
    }
    detections.objects.push_back(object);
    return *this;
  }

  // Something that is no object, before the wall.
  View& Cover(const cv::Rect& pixels, float depth_m) {
    frame.depth_m(pixels).setTo(depth_m);
    return *this;
  }

  // Not all of it was looked at.
  View& Incomplete() {
    detections.incomplete = true;
    return *this;
  }

  const Detections& TrackBy(Tracker& tracker, const FrameContext& context = {}) {
    tracker.Add(frame, context, detections);
    return detections;
  }

  RgbdFrame frame;
  Detections detections;
  double camera;
};

inline FrameContext At(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  return {{},
          CaptureTime{whole, static_cast<std::int32_t>(
                                 std::lround((seconds - static_cast<double>(whole)) * 1e9))}};
}

inline Eigen::Isometry3d PoseAt(double x_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 0));
}

inline FrameContext PosedAt(double x_m) { return {PoseAt(x_m), {}}; }

// A picture of the wall alone.
inline CameraPath::Place AddAt(CameraPath& path, double x_m, std::uint64_t seed,
                               const std::optional<Eigen::Isometry3d>& pose = {}) {
  const View view(x_m, seed);
  return path.Add(view.frame, view.detections.labels, pose);
}

}  // namespace fovea::testing
