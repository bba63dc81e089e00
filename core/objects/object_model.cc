#include "core/objects/object_model.h"

#include <limits>

namespace fovea {

double ObjectModel::LogWeight(const ObjectTerms& terms) const {
  double sum = bias;
  for (std::size_t t = 0; t < terms.size(); ++t) sum += functions[t].Of(terms[t]);
  return sum;
}

ObjectTerm ObjectModel::StrongestAgainst(const ObjectTerms& terms) const {
  std::size_t strongest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double against = functions[t].Of(terms[t]) - usual[t];
    if (against >= least) continue;
    least = against;
    strongest = t;
  }
  return static_cast<ObjectTerm>(strongest);
}

std::vector<double> ObjectModel::LogWeights(const std::vector<ObjectEvidence>& evidence) const {
  std::vector<double> weights;
  weights.reserve(evidence.size());
  for (const ObjectEvidence& of_node : evidence) weights.push_back(LogWeight(TermsOf(of_node)));
  return weights;
}

}  // namespace fovea
