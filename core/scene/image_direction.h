// Where up is in an image.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <optional>

#include "core/types/rgbd_frame.h"

namespace fovea {

// The direction in the image in which a point moves when it rises along `up`; length 1 pixel. None
// where the camera looks almost along it.
std::optional<cv::Point2f> UpInImage(const Eigen::Vector3f& point,
                                     const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up);

}  // namespace fovea
