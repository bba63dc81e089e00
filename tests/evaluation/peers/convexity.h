// PCL's supervoxels, joined and cut by convexity.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/evaluation/peers/table_removal.h"

namespace fovea::evaluation {

// The segment of each point, 0 = none: locally convex connected patches (LCCP), with
// `cut_by_planes` constrained plane cuts (CPC).
std::vector<std::uint32_t> ConvexitySegments(const PeerCloud::Ptr& cloud, bool cut_by_planes);

}  // namespace fovea::evaluation
