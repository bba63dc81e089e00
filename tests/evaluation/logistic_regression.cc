#include "tests/evaluation/logistic_regression.h"

#include <Eigen/Dense>
#include <cmath>

namespace fovea::evaluation {
namespace {

constexpr int kSteps = 50;

}  // namespace

LogisticModel FitLogistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& is_true,
                          const Eigen::VectorXd& row_weights, double penalty) {
  const Eigen::RowVectorXd mean = rows.colwise().mean();
  const Eigen::MatrixXd centered = rows.rowwise() - mean;
  const Eigen::RowVectorXd deviation =
      (centered.colwise().squaredNorm() / static_cast<double>(rows.rows())).cwiseSqrt().array() +
      1e-9;
  Eigen::MatrixXd x(rows.rows(), rows.cols() + 1);
  x << centered.array().rowwise() / deviation.array(), Eigen::VectorXd::Ones(rows.rows());
  const Eigen::VectorXd share = row_weights / row_weights.sum();
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(x.cols());
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::ArrayXd p = 1 / (1 + (-(x * beta)).array().exp());
    const Eigen::VectorXd curvature = share.array() * p * (1 - p);
    Eigen::MatrixXd hessian = x.transpose() * curvature.asDiagonal() * x;
    hessian.diagonal().array() += penalty;
    const Eigen::VectorXd gradient =
        x.transpose() * (share.array() * (is_true.array() - p)).matrix() - penalty * beta;
    beta += hessian.ldlt().solve(gradient);
  }
  const Eigen::VectorXd weights = beta.head(rows.cols()).array() / deviation.transpose().array();
  return {weights, beta[rows.cols()] - mean.dot(weights)};
}

double LogLoss(const Eigen::VectorXd& log_odds, const Eigen::VectorXd& is_true,
               const Eigen::VectorXd& row_weights) {
  const Eigen::ArrayXd of_right = log_odds.array() * (2 * is_true.array() - 1);
  return ((-of_right).exp().log1p() * row_weights.array()).sum() / row_weights.sum();
}

}  // namespace fovea::evaluation
