#include "core/grasping/grasp_model.h"

#include <cmath>

namespace fovea {

double GraspFunction::LogOdds(const GraspTerms& terms) const {
  double sum = bias;
  for (std::size_t t = 0; t < terms.size(); ++t)
    sum += functions[t].Of(static_cast<double>(terms[t]));
  return sum;
}

float GraspModel::Probability(const ScoredGrasp& grasp) const {
  const auto family = static_cast<std::size_t>(grasp.family);
  return static_cast<float>(1 / (1 + std::exp(-families[family].LogOdds(grasp.terms))));
}

}  // namespace fovea
