// Where a depth camera looks, seen by the colour camera beside it.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// A depth camera beside the colour camera, as a pinhole camera in its place sees.
struct DepthView {
  CameraIntrinsics intrinsics;
  Eigen::Isometry3d color_from_depth;
  cv::Size size;
  // CV_8UC1 of that size: 255 where its lens does not look (UnseenBy in core/lens/undistortion.h);
  // empty where it sees all of it.
  cv::Mat unseen = {};
};

// The pixels of colour at which a depth camera beside it does not look: from each end of a row or
// column to its first depth, those whose line of sight at that distance passes by what it sees.
// Where neither row nor column has any depth, it is not known.
//
// `registered_m`: CV_32FC1 as of RegisterDepth, of whose images `color` and `depth` are. Returns
// CV_8UC1 of its size, 255 = unseen. Cost: proportional to the pixels around what was measured.
cv::Mat UnseenByDepthCamera(const cv::Mat& registered_m, const CameraIntrinsics& color,
                            const DepthView& depth);

}  // namespace fovea
