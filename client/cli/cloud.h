#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// A binary PLY file of every pixel with depth, in metres in the camera frame: objects tinted in
// their palette colour, the background in dimmed true colour. `color` CV_8UC3 (B first), `depth`
// CV_16UC1 in units of `unit_m`, `labels` as LabelImage; all of one size, else throws
// std::runtime_error.
std::string MakePly(const cv::Mat& color, const cv::Mat& depth, double unit_m,
                    const v1::CameraIntrinsics& intrinsics, const cv::Mat& labels);

}  // namespace fovea::cli
