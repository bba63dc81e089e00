// How likely a grasp is to succeed.
#pragma once

#include <array>

#include "core/grasping/grasp_terms.h"

namespace fovea {

// The logarithm of the odds, a linear function of the terms.
struct GraspFunction {
  double bias = 0;
  std::array<double, kNumGraspTerms> weights{};

  double LogOdds(const GraspTerms& terms) const;
};

struct GraspModel {
  std::array<GraspFunction, kNumGraspFamilies> families;

  float Probability(const ScoredGrasp& grasp) const;
};

// Fitted to generated scenes by `fovea-eval grasp-model`; docs/quality.md says to which.
const GraspModel& FittedGraspModel();

}  // namespace fovea
