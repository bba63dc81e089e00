// The points that the depth camera measured, where the colour camera sees them.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "client/cli/request.h"

namespace fovea::cli {

struct DepthPoint {
  cv::Vec3d position;  // metres, in the frame of the colour camera
  cv::Point pixel;     // of the colour image
};

// In the order of the depth pixels. `depth`: CV_16UC1 in units of settings.depth_unit_m, 0 = none.
// Of unregistered depth, points beyond the colour image or hidden from that camera are left out.
// Registered depth must have `color_size`, else throws std::runtime_error.
std::vector<DepthPoint> PointsInColor(const cv::Mat& depth, const FrameSettings& settings,
                                      const cv::Size& color_size);

}  // namespace fovea::cli
