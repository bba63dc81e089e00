#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <utility>

#include "client/cli/overlay/block.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// Where things of a frame and of space lie in a picture of it.
struct View {
  cv::Size frame;
  int scale = 1;  // pixels of the picture per pixel of the frame
  v1::CameraIntrinsics intrinsics;

  // The middle of a frame pixel.
  cv::Point2d At(double x, double y) const {
    return {(x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5};
  }

  // None behind the camera, or so far beside it that no picture reaches there.
  std::optional<cv::Point2d> Project(const cv::Vec3d& point) const;

  // What of a line is before the camera.
  std::optional<std::pair<cv::Point2d, cv::Point2d>> Project(const SpaceLine& line) const;
};

}  // namespace fovea::cli
