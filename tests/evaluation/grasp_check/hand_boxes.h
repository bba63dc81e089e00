// The space that a hand takes on its way in, and what is in the way.
#pragma once

#include <array>
#include <span>

#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/jaw_check.h"
#include "tests/evaluation/grasp_check/outcome.h"
#include "tests/evaluation/grasp_check/physical_scene.h"
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

// What a hand of these boxes touches: the target before other objects, furniture last; kSuccess
// where it is nothing.
Outcome OnTheWayIn(const PhysicalScene& scene, int target, std::span<const SolidBox> hand);

}  // namespace fovea::evaluation
