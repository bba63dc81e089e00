// A smaller energy in place of a large one: nodes that are strongly tied become one.
#pragma once

#include <vector>

#include "core/segmentation/potts_energy.h"

namespace fovea {

// The energy of those labellings that give all nodes of a cluster one label.
struct Contraction {
  PottsEnergy energy;
  std::vector<int> cluster_of_node;  // clusters are the nodes of `energy`
};

// Joins nodes along edges of at least `min_weight` to clusters of at most `max_size` nodes: pairs
// first, then pairs of pairs, which keeps clusters compact. Nodes that can only take label 0 stay
// alone, and a cluster can take the labels that all of its nodes can.
Contraction Contract(const PottsEnergy& energy, int max_size, float min_weight);

// The labels of the nodes from those of their clusters.
std::vector<int> Expand(const Contraction& contraction, const std::vector<int>& cluster_labels);

}  // namespace fovea
