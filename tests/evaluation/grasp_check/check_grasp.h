// Whether a grasp that was answered would succeed.
#pragma once

#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/outcome.h"
#include "tests/evaluation/grasp_check/physical_scene.h"

namespace fovea::evaluation {

// `grasp`: camera frame; of suction, its kind. As CheckJaw and CheckSuction say.
Outcome CheckGrasp(const PhysicalScene& scene, int target, const Gripper& gripper,
                   const Grasp& grasp);

}  // namespace fovea::evaluation
