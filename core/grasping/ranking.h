// Which of the grasps that were found are offered.
#pragma once

#include <vector>

#include "core/grasping/grasp_terms.h"
#include "core/types/grasp.h"
#include "core/types/gripper.h"

namespace fovea {

// The likeliest first, no two nearly alike, at most as many as the gripper wants, none less likely
// than it allows. `grasps` have their probability.
std::vector<Grasp> RankGrasps(const std::vector<ScoredGrasp>& grasps, const Gripper& gripper);

}  // namespace fovea
