#pragma once

#include <opencv2/core/mat.hpp>

#include "client/capture/camera.h"
#include "client/capture/pairing.h"
#include "client/capture/v4l2_node.h"

namespace fovea::capture {

// Two nodes of the kernel, depth (Z16) and colour (YUYV), as those of a RealSense D4xx. Neither
// states intrinsics, and depth is as the depth camera sees it.
class V4l2Camera : public Camera {
 public:
  // Throws CameraError.
  explicit V4l2Camera(const CameraOptions& options);

  std::optional<Picture> Next(std::chrono::milliseconds patience) override;
  void SkipWaiting() override;
  bool AtEnd() const override { return false; }
  std::string Name() const override { return options_.device; }
  const std::string& Uri() const override { return options_.device; }
  cv::Size size() const override { return options_.size; }
  FieldOfView StatedFieldOfView() const override { return {}; }
  CameraLosses Losses() const override;

 private:
  std::optional<Picture> Read(V4l2Node& node, bool is_depth);
  void CheckSilence() const;

  CameraOptions options_;
  V4l2Node depth_, color_;
  Pairing<cv::Mat> pairing_;
  CameraLosses losses_;
  std::optional<std::uint32_t> last_sequence_;  // of depth
  bool delivered_ = false;
  std::chrono::steady_clock::time_point silent_since_;
};

}  // namespace fovea::capture
