#pragma once

#include <opencv2/core/mat.hpp>

#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// Run lengths of the pixels of `labels` (CV_16UC1) inside `bounds` that equal `label`.
v1::Mask MaskToProto(const cv::Mat& labels, int label, const cv::Rect& bounds);

v1::BoundingBox2D ToProto(const cv::Rect& bounds);

}  // namespace fovea::server
