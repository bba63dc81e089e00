#include "core/grasping/grasp_model.h"

#include <cmath>

namespace fovea {

int GraspTree::Of(const GraspTerms& of_grasp) const {
  std::size_t leaf = 0;
  for (std::size_t level = 0; level < kDepth; ++level) {
    const bool is_above = of_grasp[terms[level]] > thresholds[level];
    leaf |= static_cast<std::size_t>(is_above) << level;
  }
  return values[leaf];
}

double GraspFunction::LogOdds(const GraspTerms& terms) const {
  int sum = bias;
  for (const GraspTree& tree : trees) sum += tree.Of(terms);
  return sum / 1000.0;
}

float GraspModel::Probability(const ScoredGrasp& grasp) const {
  const auto family = static_cast<std::size_t>(grasp.family);
  return static_cast<float>(1 / (1 + std::exp(-families[family].LogOdds(grasp.terms))));
}

}  // namespace fovea
