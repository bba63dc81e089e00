#include "core/segmentation/potts_energy.h"

#include <limits>

#include "core/types/interruption.h"

namespace fovea {

std::vector<float> CostsOf(const PottsEnergy& energy, const std::vector<int>& labels) {
  std::vector<float> costs(energy.num_nodes, std::numeric_limits<float>::infinity());
  for (int label = 0; label < static_cast<int>(energy.choices.size()); ++label) {
    InterruptionPoint();
    for (const PottsEnergy::Choice& choice : energy.choices[label]) {
      if (labels[choice.node] == label) costs[choice.node] = choice.cost;
    }
  }
  return costs;
}

}  // namespace fovea
