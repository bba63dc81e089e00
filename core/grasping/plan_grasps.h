// How each object can be taken, by the grippers that the robot has.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/gripper.h"

namespace fovea {

// What grasps are planned in. Both images have the frame's size.
struct GraspScene {
  const cv::Mat& points;  // CV_32FC3, camera frame; NaN = none
  const cv::Mat& labels;  // CV_16UC1, 0 = background, k = the object with label k
  const std::vector<Support>& supports;
  const Eigen::Vector3f up;  // unit vector, against gravity
};

// Fills `grasps` and `no_grasps` of each object, which has its box and shape already.
void PlanGrasps(const GraspScene& scene, const std::vector<Gripper>& grippers,
                std::vector<DetectedObject>& objects);

}  // namespace fovea
