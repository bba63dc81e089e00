// Voxels that are labelled together: a smaller graph in place of a large one.
#pragma once

#include <vector>

#include "core/segmentation/potts_energy.h"

namespace fovea {

// Nodes of a graph in disjoint groups, numbered in the order of their first nodes.
struct Clusters {
  std::vector<int> of_node;  // -1: of none
  std::vector<int> sizes;    // in nodes
};

// Joins nodes along edges of at least `min_weight` to clusters of at most `max_size` nodes: pairs
// first, then pairs of pairs, which keeps clusters compact. Nodes with `is_left_out` set (one entry
// a node) are in none.
Clusters FindClusters(const std::vector<PottsEnergy::Edge>& edges,
                      const std::vector<char>& is_left_out, int max_size, float min_weight);

// The edges between clusters, each with the sum of the weights between the nodes of both; ascending
// by `a`, then `b`, a < b.
std::vector<PottsEnergy::Edge> EdgesBetween(const Clusters& clusters,
                                            const std::vector<PottsEnergy::Edge>& edges);

// Of each cluster the sum of the weights to nodes of none.
std::vector<float> WeightsOutwards(const Clusters& clusters,
                                   const std::vector<PottsEnergy::Edge>& edges);

// The labels of the nodes from those of their clusters; 0 for those of none.
std::vector<int> LabelsOfNodes(const Clusters& clusters, const std::vector<int>& cluster_labels);

}  // namespace fovea
