// Whether depth that counts as registered to colour is: things end in both at the same pixels.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace fovea::cli {

// How far depth lies beside colour, in pixels, x to the right and y down; none where it lies on it
// or where the two do not say. `color`: CV_8UC3, `depth`: CV_16UC1, of one size.
std::optional<cv::Point> ShiftOfDepth(const cv::Mat& color, const cv::Mat& depth);

}  // namespace fovea::cli
