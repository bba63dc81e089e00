#include "tests/evaluation/grasp_fit/boosting.h"

#include <algorithm>
#include <cmath>

namespace fovea::evaluation {
namespace {

constexpr double kThousand = 1000;
constexpr std::size_t kNumLeaves = 1U << GraspTree::kDepth;

// One term of all trials.
struct BinnedTerm {
  std::vector<float> edges;       // bin k holds what is above edges[k - 1] and not above edges[k]
  std::vector<std::uint8_t> bin;  // of each trial
};

// What a tree is fitted to: the slope of the loss of each trial and how it bends.
struct Newton {
  double slope = 0, bend = 0;

  void Add(const Newton& other) {
    slope += other.slope;
    bend += other.bend;
  }
  Newton Less(const Newton& other) const { return {slope - other.slope, bend - other.bend}; }
  double Gain(double penalty) const { return slope * slope / (bend + penalty); }
};

struct Question {
  std::size_t term = 0, edge = 0;
  double gain = -1;
};

BinnedTerm Bin(const std::vector<GraspTrial>& trials, std::size_t term, std::size_t num_bins) {
  std::vector<float> values;
  values.reserve(trials.size());
  for (const GraspTrial& trial : trials) values.push_back(trial.terms[term]);
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  BinnedTerm binned;
  for (std::size_t k = 0; k < num_bins; ++k) {
    const float edge = sorted[k * sorted.size() / num_bins];
    if (edge >= sorted.back()) break;
    if (binned.edges.empty() || edge > binned.edges.back()) binned.edges.push_back(edge);
  }
  binned.bin.reserve(values.size());
  for (const float value : values) {
    const auto edge = std::lower_bound(binned.edges.begin(), binned.edges.end(), value);
    binned.bin.push_back(static_cast<std::uint8_t>(edge - binned.edges.begin()));
  }
  return binned;
}

// The best threshold of one term for all leaves of a level at once.
Question BestOf(const BinnedTerm& of_term, std::size_t term, const std::vector<Newton>& newton,
                const std::vector<std::uint8_t>& leaf, double penalty) {
  const std::size_t num_bins = of_term.edges.size() + 1;
  std::vector<Newton> sums(kNumLeaves * num_bins);
  for (std::size_t i = 0; i < newton.size(); ++i) {
    sums[leaf[i] * num_bins + of_term.bin[i]].Add(newton[i]);
  }
  std::vector<double> gains(of_term.edges.size());
  for (std::size_t l = 0; l < kNumLeaves; ++l) {
    const Newton* bins = &sums[l * num_bins];
    Newton all, below;
    for (std::size_t b = 0; b < num_bins; ++b) all.Add(bins[b]);
    for (std::size_t e = 0; e < gains.size(); ++e) {
      below.Add(bins[e]);
      gains[e] += below.Gain(penalty) + all.Less(below).Gain(penalty);
    }
  }
  Question best;
  for (std::size_t e = 0; e < gains.size(); ++e) {
    if (gains[e] > best.gain) best = {term, e, gains[e]};
  }
  return best;
}

class Booster {
 public:
  Booster(const std::vector<GraspTrial>& trials, const BoostingOptions& options)
      : trials_(trials), options_(options), log_odds_(trials.size()), newton_(trials.size()) {
    for (std::size_t t = 0; t < kNumGraspTerms; ++t) terms_.push_back(Bin(trials, t, options.bins));
  }

  GraspFunction Fit() {
    GraspFunction function;
    function.bias = Bias();
    for (double& odds : log_odds_) odds = function.bias / kThousand;
    const bool differs = std::any_of(terms_.begin(), terms_.end(),
                                     [](const BinnedTerm& term) { return !term.edges.empty(); });
    if (!differs) return function;
    for (int i = 0; i < options_.num_trees; ++i) function.trees.push_back(NextTree());
    return function;
  }

 private:
  // With a trial of each outcome more, so that it is finite.
  int Bias() const {
    double succeed = 1, fail = 1;
    for (const GraspTrial& trial : trials_) (trial.succeeds ? succeed : fail) += trial.weight;
    return static_cast<int>(std::lround(kThousand * std::log(succeed / fail)));
  }

  GraspTree NextTree() {
    for (std::size_t i = 0; i < trials_.size(); ++i) {
      const double p = 1 / (1 + std::exp(-log_odds_[i]));
      const double weight = trials_[i].weight;
      newton_[i] = {weight * ((trials_[i].succeeds ? 1 : 0) - p), weight * p * (1 - p)};
    }
    GraspTree tree;
    std::vector<std::uint8_t> leaf(trials_.size());
    for (std::size_t level = 0; level < GraspTree::kDepth; ++level) Ask(level, tree, leaf);
    SetValues(tree, leaf);
    return tree;
  }

  void Ask(std::size_t level, GraspTree& tree, std::vector<std::uint8_t>& leaf) const {
    Question best;
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      const Question of_term = BestOf(terms_[t], t, newton_, leaf, options_.penalty);
      if (of_term.gain > best.gain) best = of_term;
    }
    tree.terms[level] = static_cast<std::uint8_t>(best.term);
    tree.thresholds[level] = terms_[best.term].edges[best.edge];
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      const bool is_above = terms_[best.term].bin[i] > best.edge;
      leaf[i] = static_cast<std::uint8_t>(leaf[i] | (is_above ? 1U : 0U) << level);
    }
  }

  void SetValues(GraspTree& tree, const std::vector<std::uint8_t>& leaf) {
    std::array<Newton, kNumLeaves> sums{};
    for (std::size_t i = 0; i < leaf.size(); ++i) sums[leaf[i]].Add(newton_[i]);
    for (std::size_t l = 0; l < kNumLeaves; ++l) {
      const double step = options_.rate * sums[l].slope / (sums[l].bend + options_.penalty);
      tree.values[l] = static_cast<std::int16_t>(std::lround(kThousand * step));
    }
    for (std::size_t i = 0; i < leaf.size(); ++i) log_odds_[i] += tree.values[leaf[i]] / kThousand;
  }

  const std::vector<GraspTrial>& trials_;
  const BoostingOptions& options_;
  std::vector<BinnedTerm> terms_;
  std::vector<double> log_odds_;
  std::vector<Newton> newton_;
};

}  // namespace

GraspFunction Boost(const std::vector<GraspTrial>& trials, const BoostingOptions& options) {
  if (trials.empty()) return {};
  return Booster(trials, options).Fit();
}

double LogLoss(const GraspFunction& function, const std::vector<GraspTrial>& trials) {
  double loss = 0, weights = 0;
  for (const GraspTrial& trial : trials) {
    const double odds = function.LogOdds(trial.terms);
    loss += trial.weight * std::log1p(std::exp(trial.succeeds ? -odds : odds));
    weights += trial.weight;
  }
  return loss / weights;
}

}  // namespace fovea::evaluation
