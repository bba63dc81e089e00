// How likely a grasp is to succeed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/grasping/grasp_terms.h"

namespace fovea {

// A decision tree that asks the same of every branch of a level, so that it is a table.
struct GraspTree {
  static constexpr std::size_t kDepth = 5;
  std::array<std::uint8_t, kDepth> terms{};
  std::array<float, kDepth> thresholds{};
  // By which terms are above their thresholds, the first is the lowest bit; thousandths of
  // log-odds.
  std::array<std::int16_t, 1U << kDepth> values{};

  int Of(const GraspTerms& of_grasp) const;
};

// The logarithm of the odds: a sum of trees. Whole numbers, so the same on every machine.
struct GraspFunction {
  int bias = 0;  // thousandths
  std::vector<GraspTree> trees;

  double LogOdds(const GraspTerms& terms) const;
};

struct GraspModel {
  std::array<GraspFunction, kNumGraspFamilies> families;

  // Of each its grasp.probability, by the function of its family.
  void SetProbabilities(std::vector<ScoredGrasp>& grasps) const;
};

// Fitted to generated scenes by `fovea-eval grasp-model`; docs/fitted_models.md says to which.
const GraspModel& FittedGraspModel();

}  // namespace fovea
