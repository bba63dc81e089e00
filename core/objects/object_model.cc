#include "core/objects/object_model.h"

#include <algorithm>
#include <limits>

namespace fovea {

double TermFunction::Of(double term) const {
  double value = slopes[0] * term;
  for (std::size_t k = 0; k < kNumKnots; ++k)
    value += slopes[k + 1] * std::max(0.0, term - knots[k]);
  return value;
}

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
