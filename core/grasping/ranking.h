// Which of the grasps that were found are offered.
#pragma once

#include <vector>

#include "core/grasping/grasp_terms.h"
#include "core/types/grasp.h"

namespace fovea {

// Less likely ones are not offered.
inline constexpr float kLeastProbability = 0.5F;

// The likeliest first, no two nearly alike, at most `max_grasps`. `grasps` have their probability.
std::vector<Grasp> RankGrasps(std::vector<ScoredGrasp> grasps, int max_grasps);

}  // namespace fovea
