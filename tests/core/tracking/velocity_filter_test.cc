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

TEST(VelocityFilter, ForgetsWhileItIsNotSeen) {
  VelocityFilter filter({0, 0, 0}, {0, 0, 0});
  filter.Predict(1);
  // 20 mm, 0.5 m/s for a second, 3 m/s2 for half of its square.
  EXPECT_NEAR(filter.deviation_m(), std::sqrt(0.02 * 0.02 + 0.5 * 0.5 + 1.5 * 1.5), 1e-9);
}

}  // namespace
}  // namespace fovea
