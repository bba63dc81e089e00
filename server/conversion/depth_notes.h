// What is odd about the depth of a frame and may be right all the same, as in frame_notes.h.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// That hardly any camera measures such depth: in another unit, of 8 bits, or with a number for
// "not measured". `depth_m`: `depth` in metres, as it was sent; NaN = not measured. Looks at
// every second row and column, of larger images at some 320 columns and as dense rows.
std::optional<std::string> OddDepth(const cv::Mat& depth_m, const v1::DepthImage& depth);

}  // namespace fovea::server
