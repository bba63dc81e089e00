#pragma once

#include <opencv2/core/mat.hpp>

#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// What else an overlay shows, as far as the answer has it.
struct OverlayExtras {
  bool seeds = false;       // the positions at which objects were looked for
  bool saliency = false;    // what stands out, in warm colours
  bool rejected = false;    // what was considered and is not reported
  bool grasps = false;      // all of each object, not the likeliest alone
  bool collisions = false;  // the collision primitives
};

// The picture that a person looks at: `color` (CV_8UC3, B first, the frame's size), and of each
// object mask, solid with its axis, likeliest grasp as a gripper in its size with the probability
// of success (red 0, yellow 50, green 100 %), number, confidence, what must be moved before it and
// why it has no grasp; free places where the answer has some. Small frames are drawn at twice their
// size. Throws std::runtime_error where the answer does not fit the frame.
cv::Mat DrawOverlay(const cv::Mat& color, const v1::CameraIntrinsics& intrinsics,
                    const v1::Detections& detections, const OverlayExtras& extras = {});

}  // namespace fovea::cli
