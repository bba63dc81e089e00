// How much the evidence speaks for an object: a sum of functions of one term each.
#pragma once

#include <array>
#include <vector>

#include "core/objects/object_terms.h"
#include "core/types/term_function.h"

namespace fovea {

// The log weight of a node of the tree of merges: how much likelier it is one object than that it
// is background and all that it consists of too (core/objects/object_choice.h).
struct ObjectModel {
  double bias = 0;
  std::array<TermFunction, kNumObjectTerms> functions;
  std::array<double, kNumObjectTerms> usual{};  // mean value of each function over true objects

  double LogWeight(const ObjectTerms& terms) const;
  // The term whose function is farthest below its usual value.
  ObjectTerm StrongestAgainst(const ObjectTerms& terms) const;
  std::vector<double> LogWeights(const std::vector<ObjectEvidence>& evidence) const;
};

// Fitted to labelled scenes and frames by `fovea-eval object-model`; docs/fitted_models.md says
// which, and what it is worth on cameras that it was not fitted to.
const ObjectModel& FittedObjectModel();

}  // namespace fovea
