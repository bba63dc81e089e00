// How each object can be taken, by the grippers that the robot has.
#pragma once

#include <vector>

#include "core/grasping/grasp_scene.h"
#include "core/grasping/grasp_terms.h"
#include "core/types/detections.h"
#include "core/types/gripper.h"

namespace fovea {

// Fills `grasps` and `no_grasps` of each object, which has its box and shape already. `candidates`,
// if given, receives for each object every grasp that was judged.
//
// Fingers move in along the gripper's approach, open 10 mm wider than the object on each side where
// they can; level as well, away from the camera, where the gripper may tilt that far. They stay
// clear of what was seen, of what objects were completed to and of what they stand on. A suction
// cup moves in along the normal of a patch. Where the palm would pass behind something that is not
// the object a tenth of the probability is left. How likely each is to succeed says a model that
// was fitted to trials by physics on generated scenes (grasp_model.h).
void PlanGrasps(const GraspScene& scene, const std::vector<Gripper>& grippers,
                std::vector<DetectedObject>& objects,
                std::vector<std::vector<ScoredGrasp>>* candidates = nullptr);

}  // namespace fovea
