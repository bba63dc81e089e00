#include "tests/evaluation/object_fit/model_fit.h"

#include <dlib/optimization.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/objects/object_choice.h"
#include "tests/evaluation/term_columns.h"

namespace fovea::evaluation {
namespace {

constexpr std::size_t kPerTerm = kColumnsOfTerm;
constexpr std::size_t kNumSlopes = kNumObjectTerms * kPerTerm;
constexpr double kFar = 1e6;  // of scaled slopes: no bound

// Which way a function may go only: what most plainly speaks for an object (1) or against one (-1).
// The few frames there are say otherwise now and then, which is chance. 0: either way.
int DirectionOf(ObjectTerm term) {
  switch (term) {
    case ObjectTerm::kFlat:
    case ObjectTerm::kClosed:
    case ObjectTerm::kEndsAnywhere:
    case ObjectTerm::kUnmeasured:
    case ObjectTerm::kLevelSegment:
      return -1;
    case ObjectTerm::kContrast:
      return 1;
    default:
      return 0;
  }
}

bool IsIn(const TreeSample& sample, const std::string& left_out) {
  return left_out.empty() || sample.group != left_out;
}

// What the slopes are multiplied by.
Eigen::RowVectorXd RowOf(const ObjectTerms& terms, const ObjectModel& knots) {
  Eigen::RowVectorXd row(kNumSlopes);
  for (std::size_t t = 0; t < kNumObjectTerms; ++t) {
    row.segment<kColumnsOfTerm>(static_cast<Eigen::Index>(t * kPerTerm)) =
        ColumnsOf(knots.functions[t], terms[t]);
  }
  return row;
}

double LogOfSum(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

// Sums over all sets of nodes of which none lies within another, or over those that are true.
struct Sums {
  double log_total = 0;
  std::vector<double> probabilities;  // of each node
};

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

// The samples of a fit as rows of scaled columns.
class Problem {
 public:
  Problem(const std::vector<TreeSample>& samples, const ObjectModel& knots,
          const std::string& left_out, const FitPenalties& penalties)
      : scale_(Eigen::VectorXd::Ones(kNumSlopes)) {
    for (const TreeSample& sample : samples) {
      if (sample.terms.empty() || !IsIn(sample, left_out)) continue;
      samples_.push_back(&sample);
      Eigen::MatrixXd rows(sample.terms.size(), kNumSlopes);
      for (std::size_t n = 0; n < sample.terms.size(); ++n) {
        rows.row(static_cast<Eigen::Index>(n)) = RowOf(sample.terms[n], knots);
      }
      rows_.push_back(std::move(rows));
    }
    Scale();
    for (Eigen::Index c = 0; c < penalty_.size(); ++c) {
      penalty_[c] = c % static_cast<Eigen::Index>(kPerTerm) == 0 ? penalties.slope : penalties.bend;
    }
  }

  // Minus the log likelihood, and its gradient by the scaled slopes and the bias, which come last.
  double Loss(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
    const Eigen::VectorXd slopes = x.head(kNumSlopes);
    double loss = slopes.dot(penalty_.cwiseProduct(slopes)) / 2;
    gradient = Eigen::VectorXd::Zero(x.size());
    gradient.head(kNumSlopes) = penalty_.cwiseProduct(slopes);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const Eigen::VectorXd log_weights = (rows_[s] * slopes).array() + x[kNumSlopes];
      const Sums all = SumOver(*samples_[s], log_weights, false);
      const Sums right = SumOver(*samples_[s], log_weights, true);
      const double weight = samples_[s]->weight;
      loss += weight * (all.log_total - right.log_total);
      Eigen::VectorXd excess(log_weights.size());
      for (Eigen::Index n = 0; n < excess.size(); ++n) {
        excess[n] = weight * (all.probabilities[n] - right.probabilities[n]);
      }
      gradient.head(kNumSlopes) += rows_[s].transpose() * excess;
      gradient[kNumSlopes] += excess.sum();
    }
    return loss;
  }

  const Eigen::VectorXd& ScaleOfColumns() const { return scale_; }

 private:
  void Scale() {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(kNumSlopes), squares = sum;
    double count = 0;
    for (const Eigen::MatrixXd& rows : rows_) {
      sum += rows.colwise().sum();
      squares += rows.array().square().matrix().colwise().sum();
      count += static_cast<double>(rows.rows());
    }
    const Eigen::ArrayXd variance = squares.array() / count - (sum.array() / count).square();
    for (Eigen::Index c = 0; c < scale_.size(); ++c) {
      if (variance[c] > 1e-12) scale_[c] = std::sqrt(variance[c]);
    }
    for (Eigen::MatrixXd& rows : rows_) {
      rows.array().rowwise() /= scale_.transpose().array();
    }
  }

  Eigen::VectorXd penalty_ = Eigen::VectorXd::Zero(kNumSlopes);
  std::vector<const TreeSample*> samples_;
  std::vector<Eigen::MatrixXd> rows_;  // of each sample
  Eigen::VectorXd scale_;
};

void SetUsual(const std::vector<TreeSample>& samples, const std::string& left_out,
              ObjectModel& model) {
  double count = 0;
  model.usual.fill(0);
  for (const TreeSample& sample : samples) {
    if (!IsIn(sample, left_out)) continue;
    for (std::size_t n = 0; n < sample.terms.size(); ++n) {
      if (sample.states[n] != NodeState::kIs) continue;
      ++count;
      for (std::size_t t = 0; t < kNumObjectTerms; ++t) {
        model.usual[t] += model.functions[t].Of(sample.terms[n][t]);
      }
    }
  }
  for (double& value : model.usual) value /= std::max(1.0, count);
}

// The slopes of functions between their knots, where bounds are plain, in place of the first one
// and what each knot adds to it; each scaled as its column is.
class SlopesBetweenKnots {
 public:
  SlopesBetweenKnots(const ObjectModel& knots, const Eigen::VectorXd& scale)
      : ratios_(Eigen::VectorXd::Zero(kNumSlopes)) {
    for (std::size_t i = 0; i < kNumSlopes; ++i) {
      const std::size_t k = i % kPerTerm;
      if (k == 0 || knots.functions[i / kPerTerm].knots[k - 1] >= TermFunction::kNoKnot) continue;
      const auto c = static_cast<Eigen::Index>(i);
      ratios_[c] = scale[c] / scale[c - 1];
    }
  }

  Eigen::VectorXd ToAdded(const Eigen::VectorXd& between) const {
    Eigen::VectorXd added = between;
    for (Eigen::Index c = 1; c < ratios_.size(); ++c) added[c] -= ratios_[c] * between[c - 1];
    return added;
  }
  Eigen::VectorXd FromAdded(const Eigen::VectorXd& added) const {
    Eigen::VectorXd between = added;
    for (Eigen::Index c = 1; c < ratios_.size(); ++c) between[c] += ratios_[c] * between[c - 1];
    return between;
  }
  // The gradient by slopes between knots, from that by what knots add.
  Eigen::VectorXd GradientOf(const Eigen::VectorXd& by_added) const {
    Eigen::VectorXd gradient = by_added;
    for (Eigen::Index c = 1; c < ratios_.size(); ++c) gradient[c - 1] -= ratios_[c] * by_added[c];
    return gradient;
  }

 private:
  Eigen::VectorXd ratios_;  // of the scales of a column and the one before it; 0 where none bends
};

using DlibVector = dlib::matrix<double, 0, 1>;

Eigen::VectorXd ToEigen(const DlibVector& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.begin(), x.size());
}

DlibVector ToDlib(const Eigen::VectorXd& x) {
  DlibVector vector(x.size());
  std::copy(x.begin(), x.end(), vector.begin());
  return vector;
}

// Of slopes between knots, and of the bias, which comes last: 0 on the side where a function may
// not go, `far` on the other.
DlibVector Bound(int side, double far) {
  DlibVector bound(kNumSlopes + 1);
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    bound(i) = DirectionOf(static_cast<ObjectTerm>(i / kPerTerm)) == -side ? 0 : side * far;
  }
  bound(kNumSlopes) = side * far;
  return bound;
}

}  // namespace

ObjectModel ModelWithKnots(const std::vector<TreeSample>& samples, const std::string& left_out) {
  ObjectModel model;
  for (std::size_t t = 0; t < static_cast<std::size_t>(ObjectTerm::kNearestJoin); ++t) {
    std::vector<double> values;
    for (const TreeSample& sample : samples) {
      if (!IsIn(sample, left_out)) continue;
      for (const ObjectTerms& terms : sample.terms) values.push_back(terms[t]);
    }
    model.functions[t] = WithKnotsAt(std::move(values));
  }
  return model;
}

ObjectModel FitModel(const std::vector<TreeSample>& samples, const ObjectModel& start,
                     const std::string& left_out, const FitPenalties& penalties,
                     int max_iterations) {
  const Problem problem(samples, start, left_out, penalties);
  const Eigen::VectorXd& scale = problem.ScaleOfColumns();
  Eigen::VectorXd x(kNumSlopes + 1);
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    const auto c = static_cast<Eigen::Index>(i);
    x[c] = start.functions[i / kPerTerm].slopes[i % kPerTerm] * scale[c];
  }
  x[kNumSlopes] = start.bias;
  const SlopesBetweenKnots between(start, scale);
  DlibVector solution = ToDlib(between.FromAdded(x));
  dlib::find_min_box_constrained(
      dlib::lbfgs_search_strategy(20), dlib::objective_delta_stop_strategy(1e-4, max_iterations),
      [&](const DlibVector& at) {
        Eigen::VectorXd gradient;
        return problem.Loss(between.ToAdded(ToEigen(at)), gradient);
      },
      [&](const DlibVector& at) {
        Eigen::VectorXd gradient;
        problem.Loss(between.ToAdded(ToEigen(at)), gradient);
        return ToDlib(between.GradientOf(gradient));
      },
      solution, Bound(-1, kFar), Bound(1, kFar));
  const Eigen::VectorXd added = between.ToAdded(ToEigen(solution));
  ObjectModel model = start;
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    const auto c = static_cast<Eigen::Index>(i);
    model.functions[i / kPerTerm].slopes[i % kPerTerm] = added[c] / scale[c];
  }
  model.bias = added[kNumSlopes];
  SetUsual(samples, left_out, model);
  return model;
}

double LossOf(const TreeSample& sample, const ObjectModel& model) {
  Eigen::VectorXd log_weights(sample.terms.size());
  for (std::size_t n = 0; n < sample.terms.size(); ++n) {
    log_weights[static_cast<Eigen::Index>(n)] = model.LogWeight(sample.terms[n]);
  }
  return SumOver(sample, log_weights, false).log_total -
         SumOver(sample, log_weights, true).log_total;
}

std::string ToSource(const ObjectModel& model) {
  std::string text =
      "// Written by `fovea-eval object-model`: the knots and slopes of each term.\n"
      "#include \"core/objects/object_model.h\"\n\nnamespace fovea {\n\n"
      "const ObjectModel& FittedObjectModel() {\n"
      "  constexpr double kNone = TermFunction::kNoKnot;\n"
      "  static const ObjectModel model{\n      // clang-format off\n";
  text += fmt::format("      .bias = {:.5g},\n      .functions = {{{{\n", model.bias);
  for (std::size_t t = 0; t < kNumObjectTerms; ++t) {
    text += fmt::format("          {},  // {}\n", SourceOf(model.functions[t]),
                        NameOf(static_cast<ObjectTerm>(t)));
  }
  text += fmt::format("      }}}},\n      .usual = {{{:.4g}}}", fmt::join(model.usual, ", "));
  return text + "\n      // clang-format on\n  };\n  return model;\n}\n\n}  // namespace fovea";
}

}  // namespace fovea::evaluation
