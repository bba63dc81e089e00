// Grasps of one object by hands with two fingers.
#pragma once

#include <vector>

#include "core/grasping/failures.h"
#include "core/grasping/grasp_terms.h"
#include "core/grasping/hand_grid.h"
#include "core/types/gripper.h"

namespace fovea {

// A hand and its place among the grippers that were asked for.
struct JawHand {
  std::size_t gripper = 0;
  JawGripper jaw;
  Failures failures;
  std::vector<ScoredGrasp> grasps;
};

// Fills `failures` and `grasps` of each hand: twelve turns of it, from that of the object's box
// on, at most 400 places each. `grid`: along the way in, wide enough for the widest hand.
void FindJawGrasps(const GraspScene& scene, const DetectedObject& object,
                   const GraspTerms& of_object, const HandGrid& grid, std::vector<JawHand>& hands);

}  // namespace fovea
