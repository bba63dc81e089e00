#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "client/cli/depth_points.h"

namespace fovea::cli {

// A binary PLY file of the points, in metres in the camera frame: objects tinted in their palette
// colour, the background in dimmed true colour. `color` CV_8UC3 (B first), `labels` as LabelImage;
// both of one size, else throws std::runtime_error, and with all pixels of the points.
std::string MakePly(const cv::Mat& color, const std::vector<DepthPoint>& points,
                    const cv::Mat& labels);

}  // namespace fovea::cli
