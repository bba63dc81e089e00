// Whether two parallel fingers take an object, judged by the true solids alone.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/outcome.h"
#include "tests/evaluation/grasp_check/physical_scene.h"

namespace fovea::evaluation {

// World frame.
struct JawPose {
  Eigen::Vector3d tool_center_point;  // midway between the finger tips
  Eigen::Vector3d approach;           // unit
  Eigen::Vector3d closing;            // unit, at right angles to the approach
  double opening_m = 0;               // that the object needs
  double moving_in_m = 0;             // of the hand that moves in; 0: 10 mm more on each side
};

// Where the pads come to rest on the target.
struct JawContacts {
  double travel_m[2];              // of the fingers towards +closing and -closing
  Eigen::Vector3d normal[2];       // unit, mean over the patch, out of the target
  Eigen::Array2d low[2], high[2];  // of the patch across the pad: along y and z of the hand
};

// The fingers close from `opening_m`, nothing else in the world. None if one of them meets nothing.
std::optional<JawContacts> CloseOn(const PhysicalScene& scene, int target,
                                   const JawGripper& gripper, const JawPose& pose,
                                   double opening_m);

// The hand opens to `moving_in_m`, as far as it can, and moves in by 150 mm along the approach:
// fingers and palm may touch nothing (they are taken for 1 mm smaller on every side). A palm of no
// size is as wide as the gripper opens at most with both fingers. Then each finger closes until its
// pad, in a grid of 2 mm, meets the target, and nothing else before. It holds if at both contacts
// (the mean over what lies within 1 mm of the first) the closing direction is within the friction
// cone of the surface, and so is some line from one patch to the other.
Outcome CheckJaw(const PhysicalScene& scene, int target, const JawGripper& gripper,
                 const JawPose& pose);

}  // namespace fovea::evaluation
