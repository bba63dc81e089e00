// Pictures of labelled frames for people.
#pragma once

#include <opencv2/core/mat.hpp>

#include "tests/support/labelled_frame.h"

namespace fovea::scenes {

// Colour, depth (near = warm, black = none) and labels side by side: CV_8UC3, BGR.
cv::Mat DrawPreview(const LabelledFrame& labelled);

}  // namespace fovea::scenes
