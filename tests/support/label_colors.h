// Colours that tell labels apart.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea::scenes {

// `labels`: CV_16UC1. Returns CV_8UC3, BGR: black for 0, a bright colour of its own for each
// label, neighbouring numbers far apart in hue.
cv::Mat ColorLabels(const cv::Mat& labels);

}  // namespace fovea::scenes
