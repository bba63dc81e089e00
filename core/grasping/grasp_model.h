// How likely a grasp is to succeed.
#pragma once

#include <array>

#include "core/grasping/grasp_terms.h"
#include "core/types/term_function.h"

namespace fovea {

// The logarithm of the odds: a sum of functions of one term each.
struct GraspFunction {
  double bias = 0;
  std::array<TermFunction, kNumGraspTerms> functions;

  double LogOdds(const GraspTerms& terms) const;
};

struct GraspModel {
  std::array<GraspFunction, kNumGraspFamilies> families;

  float Probability(const ScoredGrasp& grasp) const;
};

// Fitted to generated scenes by `fovea-eval grasp-model`; docs/quality.md says to which.
const GraspModel& FittedGraspModel();

}  // namespace fovea
