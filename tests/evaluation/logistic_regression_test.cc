#include "tests/evaluation/logistic_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fovea::evaluation {
namespace {

constexpr unsigned kSeed = 7;
constexpr int kNumRows = 20000;

struct Sample {
  Eigen::MatrixXd rows;
  Eigen::VectorXd is_true;
  Eigen::VectorXd weights;
};

// Two columns on different scales; the odds follow 1.5 · a − 0.02 · b + 0.5.
Sample DrawSample() {
  std::mt19937 random(kSeed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Sample sample{{kNumRows, 2}, Eigen::VectorXd(kNumRows), Eigen::VectorXd::Ones(kNumRows)};
  for (int i = 0; i < kNumRows; ++i) {
    const double a = normal(random), b = 100 * normal(random);
    sample.rows.row(i) << a, b;
    const double probability = 1 / (1 + std::exp(-(1.5 * a - 0.02 * b + 0.5)));
    sample.is_true[i] = uniform(random) < probability ? 1 : 0;
  }
  return sample;
}

TEST(FitLogistic, FindsTheWeightsBehindASample) {
  SCOPED_TRACE(kSeed);
  const Sample sample = DrawSample();
  const LogisticModel model = FitLogistic(sample.rows, sample.is_true, sample.weights);
  EXPECT_NEAR(model.weights[0], 1.5, 0.1);
  EXPECT_NEAR(model.weights[1], -0.02, 0.002);
  EXPECT_NEAR(model.bias, 0.5, 0.1);
}

TEST(FitLogistic, CountsRowsByTheirWeight) {
  Eigen::MatrixXd rows(4, 1);
  rows << -1, -1, 1, 1;
  const Eigen::Vector4d is_true(1, 0, 1, 0);
  const LogisticModel even = FitLogistic(rows, is_true, Eigen::Vector4d::Ones());
  EXPECT_NEAR(even.weights[0], 0, 1e-6);
  const LogisticModel rising = FitLogistic(rows, is_true, Eigen::Vector4d(1, 9, 9, 1));
  EXPECT_NEAR(rising.LogOdds(rows)[2], std::log(9), 0.05);
  EXPECT_NEAR(rising.LogOdds(rows)[0], -std::log(9), 0.05);
}

TEST(FitLogistic, StaysFiniteWhereClassesAreApart) {
  Eigen::MatrixXd rows(2, 1);
  rows << -1, 1;
  const LogisticModel model = FitLogistic(rows, Eigen::Vector2d(0, 1), Eigen::Vector2d::Ones());
  EXPECT_TRUE(std::isfinite(model.weights[0]));
  EXPECT_GT(model.weights[0], 1);
}

TEST(LogLoss, IsTheMeanOfTheLogarithms) {
  const Eigen::Vector2d log_odds(std::log(4), std::log(4));  // 80 %
  EXPECT_NEAR(LogLoss(log_odds, Eigen::Vector2d(1, 0), Eigen::Vector2d(3, 1)),
              -(3 * std::log(0.8) + std::log(0.2)) / 4, 1e-12);
}

}  // namespace
}  // namespace fovea::evaluation
