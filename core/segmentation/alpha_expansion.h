// Minimisation of a Potts energy by graph cuts (Boykov, Veksler and Zabih 2001; the paper's
// reference [19]).
#pragma once

#include <vector>

#include "core/segmentation/potts_energy.h"

namespace fovea {

// Starts from each node's cheapest label (the lowest of equals) and expands one label after the
// other, each by an exact minimum cut, until a sweep changes nothing or `max_sweeps` is reached. At
// convergence the energy is within a factor of two of the optimum. Returns one label a node. Cost:
// grows with the number of choices.
std::vector<int> MinimizeByAlphaExpansion(const PottsEnergy& energy, int max_sweeps);

}  // namespace fovea
