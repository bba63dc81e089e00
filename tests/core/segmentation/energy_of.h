// What alpha-expansion and clusters are judged by.
#pragma once

#include "core/segmentation/potts_energy.h"

namespace fovea {

// The energy of a labelling, one entry a node; infinite if a node has a label it cannot take.
inline double EnergyOf(const PottsEnergy& energy, const std::vector<int>& labels) {
  double total = 0;
  for (const float cost : CostsOf(energy, labels)) total += cost;
  for (const PottsEnergy::Edge& edge : energy.edges) {
    if (labels[edge.a] != labels[edge.b]) total += edge.weight;
  }
  return total;
}

}  // namespace fovea
