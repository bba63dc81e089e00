// Pictures of grasps and how they end, for people.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "core/types/rgbd_frame.h"
#include "tests/evaluation/grasp_check/outcome.h"

namespace fovea::evaluation {

struct EndedGrasp {
  Grasp grasp;
  Outcome outcome = Outcome::kSuccess;
};

// The frame, twice as large, with each hand in its size: pads, palm and stem of jaws as far apart
// as the object needs, the lip and tube of a cup. Green: succeeds; red: fails, with the cause; and
// the probability that was answered. CV_8UC3, BGR.
cv::Mat DrawGrasps(const RgbdFrame& frame, const Gripper& gripper,
                   const std::vector<EndedGrasp>& grasps);

}  // namespace fovea::evaluation
