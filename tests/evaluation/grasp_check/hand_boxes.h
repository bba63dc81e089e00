// The space that a hand takes on its way in.
#pragma once

#include <array>

#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/jaw_check.h"
#include "tests/evaluation/grasp_check/solid_box.h"

namespace fovea::evaluation {

// Columns: closing, across both, approach.
Eigen::Matrix3d HandAxes(const Eigen::Vector3d& approach, const Eigen::Vector3d& closing);

// The box from one corner to the opposite one, in the hand's frame at `tool_center_point`.
SolidBox BoxOfHand(const Eigen::Matrix3d& axes, const Eigen::Vector3d& tool_center_point,
                   const Eigen::Vector3d& low, const Eigen::Vector3d& high);

// Both fingers, `opening_m` apart, and the palm, drawn out backwards by `sweep_m`, each of them
// smaller by `inset_m` on every side.
std::array<SolidBox, 3> SweptHand(const JawGripper& gripper, const JawPose& pose, double opening_m,
                                  double sweep_m, double inset_m);

}  // namespace fovea::evaluation
