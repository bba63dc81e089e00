// Where a point is seen.
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

}  // namespace fovea
