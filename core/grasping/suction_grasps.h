// Grasps of one object by suction cups.
#pragma once

#include <vector>

#include "core/grasping/failures.h"
#include "core/grasping/grasp_terms.h"
#include "core/grasping/hand_grid.h"
#include "core/types/gripper.h"

namespace fovea {

// Of at most 64 patches that are spread over the mask, those that the cup may seal on and reach
// without touching anything else, no farther from the gripper's preferred approach than it may
// tilt. `grid`: around the object, against that approach or another one.
std::vector<ScoredGrasp> FindSuctionGrasps(const GraspScene& scene, const DetectedObject& object,
                                           const GraspTerms& of_object, const HandGrid& grid,
                                           const Gripper& gripper, std::size_t index,
                                           Failures& failures);

}  // namespace fovea
