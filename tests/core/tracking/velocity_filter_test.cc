#include "core/tracking/velocity_filter.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

TEST(VelocityFilter, LearnsAConstantVelocity) {
  VelocityFilter filter({0, 0, 1}, {0, 0, 0});
  for (int i = 1; i <= 20; ++i) {
    filter.Predict(0.1);
    filter.Update({0.03F * static_cast<float>(i), 0, 1}, 0.01);
  }
  EXPECT_NEAR(filter.velocity().x(), 0.3, 0.01);
  EXPECT_NEAR(filter.position().x(), 0.6, 0.005);
  filter.Predict(0.5);
  EXPECT_NEAR(filter.position().x(), 0.75, 0.01);
}

// By hand, from a position known to 20 mm and a speed known to 0.5 m/s: no time passes, so that a
// measurement with 20 mm counts as much as the position.
TEST(VelocityFilter, WeighsByVariance) {
  VelocityFilter filter({0, 0, 0}, {0, 0, 0});
  filter.Update({0.1F, 0, 0}, 0.02);
  EXPECT_FLOAT_EQ(filter.position().x(), 0.05F);
  EXPECT_NEAR(filter.deviation_m(), 0.02 / std::sqrt(2), 1e-9);
  EXPECT_FLOAT_EQ(filter.velocity().x(), 0);
}

// In one dimension, with matrices.
TEST(VelocityFilter, IsTheKalmanFilterOfPositionAndVelocity) {
  VelocityFilter filter({0, 0, 0}, {0.2F, 0, 0});
  Eigen::Vector2d state(0, 0.2F);
  Eigen::Matrix2d variance = Eigen::Vector2d(0.02 * 0.02, 0.5 * 0.5).asDiagonal();
  for (const float measured : {0.03F, 0.01F, 0.08F}) {
    const double t = 0.1;
    const Eigen::Matrix2d step{{1, t}, {0, 1}};
    const Eigen::Vector2d by_acceleration(3 * t * t / 2, 3 * t);
    state = step * state;
    variance = step * variance * step.transpose() + by_acceleration * by_acceleration.transpose();
    const Eigen::Vector2d gain = variance.col(0) / (variance(0, 0) + 0.01 * 0.01);
    state += gain * (measured - state[0]);
    variance -= gain * variance.row(0).eval();
    filter.Predict(t);
    filter.Update({measured, 0, 0}, 0.01);
    EXPECT_NEAR(filter.position().x(), state[0], 1e-7);
    EXPECT_NEAR(filter.velocity().x(), state[1], 1e-6);
  }
}

TEST(VelocityFilter, TurnsWithTheCamera) {
  VelocityFilter filter({1, 0, 0}, {0.2F, 0, 0});
  filter.Transform(Eigen::Translation3f(0, 0, 5) *
                   Eigen::AngleAxisf(static_cast<float>(EIGEN_PI) / 2, Eigen::Vector3f::UnitZ()));
  EXPECT_TRUE(filter.position().isApprox(Eigen::Vector3f(0, 1, 5), 1e-5F));
  EXPECT_TRUE(filter.velocity().isApprox(Eigen::Vector3f(0, 0.2F, 0), 1e-5F));
}

TEST(VelocityFilter, ForgetsWhileItIsNotSeen) {
  VelocityFilter filter({0, 0, 0}, {0, 0, 0});
  filter.Predict(1);
  // 20 mm, 0.5 m/s for a second, 3 m/s2 for half of its square.
  EXPECT_NEAR(filter.deviation_m(), std::sqrt(0.02 * 0.02 + 0.5 * 0.5 + 1.5 * 1.5), 1e-9);
}

}  // namespace
}  // namespace fovea
