// Trees fitted one after the other, each to what those before it leave unexplained.
#pragma once

#include <vector>

#include "core/grasping/grasp_model.h"

namespace fovea::evaluation {

struct GraspTrial {
  GraspTerms terms;
  double weight = 1;  // all candidates of one object and gripper together count 1
  bool succeeds = false;
};

struct BoostingOptions {
  int num_trees = 200;
  double rate = 0.25;     // of what each tree explains, this share is taken
  double penalty = 3;     // weight of trials, in objects, that a leaf must have to count half
  std::size_t bins = 32;  // quantiles of a term that may be thresholds
};

// Newton boosting of the logistic loss (Friedman 2000; second-order gain as in Chen and Guestrin
// 2016) with oblivious trees (Prokhorenkova et al. 2018). The same trials give the same trees.
// No trials give no trees; a term of one value is never asked.
GraspFunction Boost(const std::vector<GraspTrial>& trials, const BoostingOptions& options = {});

// Weighted mean of -log p of what happened; NaN without trials.
double LogLoss(const GraspFunction& function, const std::vector<GraspTrial>& trials);

}  // namespace fovea::evaluation
