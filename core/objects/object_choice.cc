#include "core/objects/object_choice.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

double LogOfSum(double log_a, double log_b) {
  const double larger = std::max(log_a, log_b);
  return larger + std::log1p(std::exp(std::min(log_a, log_b) - larger));
}

}  // namespace

std::vector<double> ObjectProbabilities(const MergeTree& tree,
                                        const std::vector<double>& log_weights) {
  const std::size_t count = tree.nodes.size();
  std::vector<double> whole(count);  // probability of a node if it lies within no other object
  std::vector<double> total(count);  // logarithm of the sum over all sets within a node
  for (std::size_t n = 0; n < count; ++n) {
    const MergeNode& node = tree.nodes[n];
    const double apart = node.left < 0 ? 0 : total[node.left] + total[node.right];
    total[n] = LogOfSum(log_weights[n], apart);
    whole[n] = std::exp(log_weights[n] - total[n]);
  }
  std::vector<double> outside(count, 1);  // probability that it lies within no other object
  std::vector<double> probabilities(count);
  for (std::size_t n = count; n-- > 0;) {
    const int parent = tree.nodes[n].parent;
    if (parent >= 0) outside[n] = outside[parent] * (1 - whole[parent]);
    probabilities[n] = outside[n] * whole[n];
  }
  return probabilities;
}

std::vector<int> ChooseObjects(const MergeTree& tree, const std::vector<double>& probabilities,
                               const ChoiceOptions& options) {
  const std::size_t count = tree.nodes.size();
  std::vector<double> best(count);  // sum over the best choice within a node
  std::vector<char> is_whole(count, 0);
  for (std::size_t n = 0; n < count; ++n) {
    const MergeNode& node = tree.nodes[n];
    const double apart = node.left < 0 ? 0 : best[node.left] + best[node.right];
    const double whole = probabilities[n] - options.min_probability;
    is_whole[n] = whole > apart ? 1 : 0;
    best[n] = std::max(whole, apart);
  }
  std::vector<int> chosen;
  std::vector<char> is_within(count, 0);  // something chosen
  for (std::size_t n = count; n-- > 0;) {
    const int parent = tree.nodes[n].parent;
    is_within[n] = parent >= 0 && is_within[parent];
    if (is_within[n] || !is_whole[n]) continue;
    is_within[n] = 1;
    chosen.push_back(static_cast<int>(n));
  }
  std::reverse(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<int> LabelsOfChosen(const MergeTree& tree, const std::vector<int>& chosen,
                                const std::vector<int>& labels) {
  std::vector<int> label_of(tree.nodes.size(), 0);
  for (std::size_t k = 0; k < chosen.size(); ++k) label_of[chosen[k]] = static_cast<int>(k) + 1;
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const int parent = tree.nodes[n].parent;
    if (parent >= 0 && label_of[parent] != 0) label_of[n] = label_of[parent];
  }
  std::vector<int> result(labels.size(), 0);
  std::transform(labels.begin(), labels.end(), result.begin(),
                 [&](int label) { return label == 0 ? 0 : label_of[label - 1]; });
  return result;
}

}  // namespace fovea
