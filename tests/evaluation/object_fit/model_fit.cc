#include "tests/evaluation/object_fit/model_fit.h"

#include <dlib/optimization.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/evaluation/object_fit/slope_bounds.h"
#include "tests/evaluation/object_fit/tree_sums.h"
#include "tests/evaluation/term_columns.h"

namespace fovea::evaluation {
namespace {

constexpr std::size_t kPerTerm = kColumnsOfTerm;

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

Eigen::VectorXd WithBias(const Eigen::VectorXd& slopes, double bias) {
  Eigen::VectorXd all(slopes.size() + 1);
  all << slopes, bias;
  return all;
}

using DlibVector = dlib::matrix<double, 0, 1>;

Eigen::VectorXd ToEigen(const DlibVector& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.begin(), x.size());
}

DlibVector ToDlib(const Eigen::VectorXd& x) {
  DlibVector vector(x.size());
  std::copy(x.begin(), x.end(), vector.begin());
  return vector;
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
  Eigen::VectorXd slopes(kNumSlopes);
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    const auto c = static_cast<Eigen::Index>(i);
    slopes[c] = start.functions[i / kPerTerm].slopes[i % kPerTerm] * scale[c];
  }
  const SlopesBetweenKnots between(start, scale);
  DlibVector solution = ToDlib(between.FromAdded(WithBias(slopes, start.bias)));
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
      solution, ToDlib(WithBias(LowerBounds(), -kNoBound)),
      ToDlib(WithBias(UpperBounds(), kNoBound)));
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
