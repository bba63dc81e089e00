// From a depth image of one camera to the depth that another camera would see.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// Depth of the colour camera's pixels, from an image that a depth camera beside it took.
//
// `depth_m`: CV_32FC1, metres along the depth camera's z; NaN, infinite or <= 0 = none.
// `color_from_depth` takes points of the depth camera's frame to the colour camera's; metres.
// Returns CV_32FC1 of `color_size`, metres along the colour camera's z; NaN where nothing was
// measured: the depth camera does not look there, something hides it from that camera, it measured
// nothing, or the point is nearer than 1 cm to the plane of the colour camera.
//
// The surface between neighbouring depth pixels is drawn, with 1/z linear in the image as on a
// plane, and the nearest surface wins. Neighbours are of one surface unless their depths differ by
// more than those of a plane seen 80° from its normal, and by more than 1 %. There each pixel goes
// on at its own depth for the half pixel to the edge, and nothing is drawn between them. The depth
// at the centre of a depth pixel is what was measured, so with identical cameras depth and holes
// stay as they are.
//
// Throws std::invalid_argument where an image is empty or depth of another type, and where drawing
// takes more than 32 steps a pixel of both images, as it may for noise just in front of the colour
// camera. So the cost is linear in their pixels: some 60 ns a depth pixel and 8 ns a colour pixel.
cv::Mat RegisterDepth(const cv::Mat& depth_m, const CameraIntrinsics& depth_intrinsics,
                      const Eigen::Isometry3d& color_from_depth,
                      const CameraIntrinsics& color_intrinsics, const cv::Size& color_size);

}  // namespace fovea
