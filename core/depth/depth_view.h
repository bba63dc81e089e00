// Where a depth camera looks, seen by the colour camera beside it.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// The pixels of colour at which a depth camera beside it does not look: from each end of a row or
// column to its first depth, those whose line of sight at that distance passes the depth image by.
// Where neither row nor column has any depth, it is not known.
//
// `registered_m`: CV_32FC1 as of RegisterDepth, of whose images `color` and `depth` are. Returns
// CV_8UC1 of its size, 255 = unseen. Cost: proportional to the pixels around what was measured.
cv::Mat UnseenByDepthCamera(const cv::Mat& registered_m, const CameraIntrinsics& color,
                            const Eigen::Isometry3d& color_from_depth,
                            const CameraIntrinsics& depth, const cv::Size& depth_size);

}  // namespace fovea
