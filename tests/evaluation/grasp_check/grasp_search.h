// Whether an object can be taken at all, by a search with the true solids.
#pragma once

#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/physical_scene.h"

namespace fovea::evaluation {

// Moving in straight down (jaws), or along the surface's normal up to the gripper's largest tilt
// (suction): true if CheckJaw or CheckSuction accepts any of a grid of places over the object, some
// 10 mm apart (at most 13 by 13), for jaws with 12 yaws, 6 depths and two openings to close from.
// Slow: a second where there is none.
bool IsPossible(const PhysicalScene& scene, int target, const Gripper& gripper);

}  // namespace fovea::evaluation
