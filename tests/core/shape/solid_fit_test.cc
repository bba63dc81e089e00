#include "core/shape/solid_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shape/shape_fit.h"

namespace fovea {
namespace {

constexpr float kRadius_m = 0.04F, kHeight_m = 0.09F;

// The far half of the inside of a cup, seen from above over its near rim, and its front.
SeenObject CupWithoutRim(float wall_m) {
  constexpr int kAround = 12, kLevels = 5;
  SeenObject seen;
  seen.points = LevelPoints(Eigen::Index{2} * kAround * kLevels);
  seen.camera = {0, -0.5F, 0.7F};
  Eigen::Index next = 0;
  for (const float side : {-1.0F, 1.0F}) {  // the front, and the inside behind the axis
    const float radius = side > 0 ? kRadius_m - wall_m : kRadius_m;
    for (int i = 0; i < kAround; ++i) {
      const float angle = (static_cast<float>(i) + 0.5F) / kAround * static_cast<float>(M_PI);
      for (int k = 0; k < kLevels; ++k) {
        seen.points.x[next] = radius * std::cos(angle);
        seen.points.y[next] = side * radius * std::sin(angle);
        seen.points.h[next++] = kHeight_m - 0.02F - 0.008F * static_cast<float>(k);
      }
    }
  }
  seen.noise_m = SeenArray::Constant(next, 0.003F);
  return seen;
}

Solid RoughCup() {
  Solid start;
  start.kind = Solid::Kind::kUprightCylinder;
  start.radius_m = 0.044F;
  start.height_m = kHeight_m;
  return start;
}

TEST(FitSolids, WhatIsSeenOfAnInsideMakesACupHollowThoughNoRimIsSeen) {
  const FittedSolid cup = FitSolids(CupWithoutRim(0.0035F), {RoughCup()}).front();
  EXPECT_GT(cup.hollow_share, 0.5F);
  EXPECT_TRUE(IsHollow(cup));
}

TEST(FitSolids, TheInsideTellsWhereTheWallIs) {
  const FittedSolid cup = FitSolids(CupWithoutRim(0.0035F), {RoughCup()}).front();
  EXPECT_NEAR(cup.solid.radius_m, kRadius_m, 0.0005F);
  EXPECT_LT(cup.cost, 0.1F);
  // An inside that is nowhere near the wall costs more, up to a bound: it may have any shape.
  const FittedSolid thick = FitSolids(CupWithoutRim(0.015F), {RoughCup()}).front();
  EXPECT_GT(thick.cost, cup.cost + 0.05F);
  EXPECT_LT(thick.cost, 0.34F);
}

TEST(FitSolids, AnOblongOfWhichOnlyTheFrontIsSeenIsHardlyLongerThanWide) {
  constexpr int kAround = 16, kLevels = 6;
  SeenObject seen;  // half of a round front
  seen.points = LevelPoints(Eigen::Index{kAround} * kLevels);
  seen.camera = {0, -0.6F, 0.2F};
  Eigen::Index next = 0;
  for (int i = 0; i < kAround; ++i) {
    const float angle = (static_cast<float>(i) + 0.5F) / kAround * static_cast<float>(M_PI);
    for (int k = 0; k < kLevels; ++k) {
      seen.points.x[next] = kRadius_m * std::cos(angle);
      seen.points.y[next] = -kRadius_m * std::sin(angle);
      seen.points.h[next++] = 0.01F + 0.015F * static_cast<float>(k);
    }
  }
  seen.noise_m = SeenArray::Constant(next, 0.003F);
  Solid start;
  start.kind = Solid::Kind::kOblong;
  start.along = {0, 1};  // away from the camera
  start.half_length_m = 0.06F;
  start.half_width_m = 0.04F;
  start.height_m = 0.09F;
  const Solid solid = FitSolids(seen, {start}).front().solid;
  EXPECT_NEAR(solid.half_width_m, kRadius_m, 0.002F);
  EXPECT_LT(solid.half_length_m, 0.05F);
}

TEST(FitSolids, ThatExplainMuchLessThanTheBestAreLeftAfterTheFirstSteps) {
  const SeenObject seen = CupWithoutRim(0.0035F);
  Solid board;  // a solid that the points are no part of
  board.half_length_m = board.half_width_m = 0.03F;
  board.height_m = 0.02F;
  const FittedSolid alone = FitSolids(seen, {board}).front();
  const std::vector<FittedSolid> both = FitSolids(seen, {RoughCup(), board});
  EXPECT_EQ(both[0].cost, FitSolids(seen, {RoughCup()}).front().cost);
  EXPECT_GT(both[1].cost, both[0].cost + 0.1F);
  EXPECT_NE(both[1].solid.half_length_m, alone.solid.half_length_m);
}

}  // namespace
}  // namespace fovea
