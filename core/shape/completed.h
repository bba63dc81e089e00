// What a fitted solid says of its object.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/shape/shape_fit.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Fills `shape`, `box` and `yaw_is_arbitrary`, whatever they were. What is round about the upright
// has its box's x axis point away from the camera. A shape of kind kOther keeps the box of what was
// seen, down to the plane of the frame.
void SetShape(const FittedShape& fitted, const LevelFrame& frame, DetectedObject& object);

// Fills `unseen_share` from points that are spread over the solid: those that face away from the
// camera, or fall beside the mask, are unseen. `labels`: CV_16UC1.
void SetUnseenShare(const cv::Mat& labels, const CameraIntrinsics& intrinsics,
                    const FittedShape& fitted, const LevelFrame& frame, DetectedObject& object);

}  // namespace fovea
