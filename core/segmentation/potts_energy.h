// Multi-label energies with Potts-like pairwise terms: the form of the paper's Eq. 1.
#pragma once

#include <vector>

#include "core/types/lists.h"

namespace fovea {

// E(y) = Σ_v cost(v, y_v) + Σ_(a,b) weight · [y_a ≠ y_b]. A node can only take the labels that
// offer it as a choice; label 0 offers every node.
struct PottsEnergy {
  struct Choice {
    int node = 0;
    float cost = 0;
  };
  struct Edge {
    int a = 0;
    int b = 0;
    float weight = 0;  // ≥ 0
  };

  int num_nodes = 0;
  Lists<Choice> choices;  // of each label, nodes ascending
  std::vector<Edge> edges;
};

// What each node's label costs it, one entry a node; infinite for labels it cannot take.
std::vector<float> CostsOf(const PottsEnergy& energy, const std::vector<int>& labels);

}  // namespace fovea
