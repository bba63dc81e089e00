#include "core/segmentation/potts_energy.h"

#include <limits>

namespace fovea {

double EnergyOf(const PottsEnergy& energy, const std::vector<int>& labels) {
  std::vector<double> costs(energy.num_nodes, std::numeric_limits<double>::infinity());
  for (int label = 0; label < static_cast<int>(energy.choices.size()); ++label) {
    for (const PottsEnergy::Choice& choice : energy.choices[label]) {
      if (labels[choice.node] == label) costs[choice.node] = choice.cost;
    }
  }
  double total = 0;
  for (const double cost : costs) total += cost;
  for (const PottsEnergy::Edge& edge : energy.edges) {
    if (labels[edge.a] != labels[edge.b]) total += edge.weight;
  }
  return total;
}

}  // namespace fovea
