// How sure a detection is.
#pragma once

#include <opencv2/core/types.hpp>

#include "core/types/detections.h"

namespace fovea {

// 1 − exp(−n / n₀) of the number n of mask pixels, with n₀ = 1/300 of the image (1024 pixels of
// 640×480): false detections are mostly fragments, so size ranks them last. A rank, not yet a
// calibrated probability.
float Confidence(const DetectedObject& object, const cv::Size& image);

}  // namespace fovea
