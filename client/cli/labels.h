#pragma once

#include <opencv2/core/mat.hpp>

#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// The object's mask as CV_8UC1 of its bounds, 255 = object.
cv::Mat MaskImage(const v1::Object& object);

// Frame size: 0 = background, k = object k. CV_8UC1 up to 255 objects, else CV_16UC1.
cv::Mat LabelImage(const v1::Detections& detections);

// Throws std::runtime_error unless the object's bounds lie inside a frame of this size.
cv::Rect BoundsOf(const v1::BoundingBox2D& bounds, const cv::Size& frame);

}  // namespace fovea::cli
