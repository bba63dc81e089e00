#include "tests/evaluation/object_fit/tree_sums.h"

#include <algorithm>
#include <cmath>

namespace fovea::evaluation {
namespace {

double LogOfSum(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

}  // namespace

Sums SumOver(const TreeSample& sample, const Eigen::VectorXd& log_weights, bool true_ones) {
  const std::vector<MergeNode>& nodes = sample.tree.nodes;
  std::vector<double> total(nodes.size()), whole(nodes.size());
  Sums sums;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const double apart = nodes[n].left < 0 ? 0 : total[nodes[n].left] + total[nodes[n].right];
    const double weight = log_weights[static_cast<Eigen::Index>(n)];
    const NodeState state = true_ones ? sample.states[n] : NodeState::kMayBe;
    total[n] = state == NodeState::kIs      ? weight
               : state == NodeState::kIsNot ? apart
                                            : LogOfSum(weight, apart);
    whole[n] = state == NodeState::kIsNot ? 0 : std::exp(weight - total[n]);
    if (nodes[n].parent < 0) sums.log_total += total[n];
  }
  std::vector<double> outside(nodes.size(), 1);
  sums.probabilities.resize(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (nodes[n].parent >= 0) outside[n] = outside[nodes[n].parent] * (1 - whole[nodes[n].parent]);
    sums.probabilities[n] = outside[n] * whole[n];
  }
  return sums;
}

}  // namespace fovea::evaluation
