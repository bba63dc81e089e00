#pragma once

#include <opencv2/core/mat.hpp>

#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// The picture that a person looks at: `color` (CV_8UC3, B first, the frame's size) with masks,
// contours, boxes, grasps, seeds and numbers. Small frames are drawn at twice their size.
cv::Mat DrawOverlay(const cv::Mat& color, const v1::CameraIntrinsics& intrinsics,
                    const v1::Detections& detections);

}  // namespace fovea::cli
