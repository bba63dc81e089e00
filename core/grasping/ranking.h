// Which of the grasps that were found are offered.
#pragma once

#include <functional>
#include <vector>

#include "core/grasping/grasp_terms.h"
#include "core/types/grasp.h"
#include "core/types/gripper.h"

namespace fovea {

// The likeliest first, no two nearly alike, at most as many as the gripper wants, none less likely
// than it allows. `grasps` have their probability. `doubt` is asked for each that may be offered
// how much of its probability is left, 0 … 1; it may write to the grasp.
std::vector<Grasp> RankGrasps(const std::vector<ScoredGrasp>& grasps, const Gripper& gripper,
                              const std::function<float(Grasp&)>& doubt);

}  // namespace fovea
