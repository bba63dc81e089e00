// Minimisation of a Potts energy by graph cuts (Boykov, Veksler and Zabih 2001; the paper's
// reference [19]).
#pragma once

#include <vector>

#include "core/segmentation/potts_energy.h"

namespace fovea {

struct ExpansionOptions {
  int max_sweeps = 5;
  // Sweeps over a labelling only expand labels that some node has: others hardly come back, and
  // most labels are others after the first sweep.
  bool only_owners = false;
};

// Starts from each node's cheapest label (the lowest of equals) and expands one label after the
// other, each by an exact minimum cut, until a sweep changes nothing or `max_sweeps` is reached. At
// convergence over all labels the energy is within a factor of two of the optimum. The first sweep
// is over all labels. Returns one label a node. Cost: grows with the number of choices.
std::vector<int> MinimizeByAlphaExpansion(const PottsEnergy& energy,
                                          const ExpansionOptions& options = {});

// The same from `labels`, one entry a node: never a higher energy than theirs.
std::vector<int> ImproveByAlphaExpansion(const PottsEnergy& energy, const std::vector<int>& labels,
                                         const ExpansionOptions& options = {});

}  // namespace fovea
