// Where a point is seen, and what a pixel sees.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// The pixel at which the camera sees a point in its frame; z must be positive.
inline cv::Point2d Project(const Eigen::Vector3f& point, const CameraIntrinsics& intrinsics) {
  return {intrinsics.fx_px * point.x() / point.z() + intrinsics.cx_px,
          intrinsics.fy_px * point.y() / point.z() + intrinsics.cy_px};
}

// The point at depth 1 that the camera sees at a pixel.
inline Eigen::Vector3f RayOf(const cv::Point& pixel, const CameraIntrinsics& intrinsics) {
  return Eigen::Vector3d((pixel.x - intrinsics.cx_px) / intrinsics.fx_px,
                         (pixel.y - intrinsics.cy_px) / intrinsics.fy_px, 1)
      .cast<float>();
}

}  // namespace fovea
