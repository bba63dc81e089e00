// Weights of a linear function that tells two classes apart.
#pragma once

#include <Eigen/Core>

namespace fovea::evaluation {

struct LogisticModel {
  Eigen::VectorXd weights;  // one a column
  double bias = 0;

  // The logarithm of the odds of each row.
  Eigen::VectorXd LogOdds(const Eigen::MatrixXd& rows) const {
    return (rows * weights).array() + bias;
  }
};

// The model that gives `is_true` (0 or 1) the highest likelihood, each row counted with its weight;
// `penalty` / 2 · |weights|² on columns scaled to variance 1, beside the mean loss of a row, keeps
// it finite. Newton's method. Expects at least one row.
LogisticModel FitLogistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& is_true,
                          const Eigen::VectorXd& row_weights, double penalty = 1e-5);

// Mean of −ln p(right class), weighted.
double LogLoss(const Eigen::VectorXd& log_odds, const Eigen::VectorXd& is_true,
               const Eigen::VectorXd& row_weights);

}  // namespace fovea::evaluation
