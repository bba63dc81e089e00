// How an answer came about, for people: `fovea detect --explain`.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "client/cli/request.h"

namespace fovea::cli {

// Writes a picture of each step into `folder`, which is there, and index.html, which shows them
// side by side with what was left after each. `color`: CV_8UC3, B first; `depth`: CV_16UC1 as sent;
// `detections` must have masks and a trace. Throws std::runtime_error.
void WriteSteps(const std::string& folder, const cv::Mat& color, const cv::Mat& depth,
                const FrameSettings& settings, const v1::Detections& detections);

}  // namespace fovea::cli
