// Over all sets of objects that a tree of merges allows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/evaluation/object_fit/tree_samples.h"

namespace fovea::evaluation {

struct Sums {
  double log_total = 0;
  std::vector<double> probabilities;  // of each node
};

// Sums of the weights of all sets of nodes of which none lies within another, or, with `true_ones`,
// of those that are true. `log_weights`: of each node. Cost: proportional to the nodes.
Sums SumOver(const TreeSample& sample, const Eigen::VectorXd& log_weights, bool true_ones);

}  // namespace fovea::evaluation
