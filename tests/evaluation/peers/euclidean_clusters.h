// PCL's clusters by distance.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/evaluation/peers/table_removal.h"

namespace fovea::evaluation {

// The cluster of each point, from 1: points closer than the tolerance to one another.
std::vector<std::uint32_t> EuclideanClusters(const PeerCloud::Ptr& cloud);

}  // namespace fovea::evaluation
