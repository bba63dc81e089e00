// Between pixels and rays of a camera, with the distortion of its lens where it has some.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// Where the camera sees these points (metres, all of them before it) in images of `size`. Far
// beside the image, where coefficients say nothing, as a pinhole would. Throws cv::Exception for
// coefficients of which no server takes so many.
std::vector<cv::Point2d> PixelsOf(const std::vector<cv::Vec3d>& points,
                                  const v1::CameraIntrinsics& intrinsics, const cv::Size& size);

// (x / z, y / z) of what each pixel sees, CV_64FC2. With distortion some 0.1 s a megapixel.
cv::Mat RaysOf(const v1::CameraIntrinsics& intrinsics, const cv::Size& size);

}  // namespace fovea::cli
