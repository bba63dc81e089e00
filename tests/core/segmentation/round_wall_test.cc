#include "core/segmentation/round_wall.h"

#include <gtest/gtest.h>

#include "core/segmentation/labels.h"
#include "core/segmentation/round_wall_merge.h"
#include "tests/core/segmentation/cup.h"

namespace fovea {
namespace {

constexpr double kMaxRadius_m = 0.2;

TEST(FindRoundWalls, MeasuresTheCircleOfAWallSeenFromInside) {
  const Cup cup;
  const auto walls = FindRoundWalls(cup.grid, cup.labels, kUp, kMaxRadius_m);
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_FALSE(walls[0]);
  ASSERT_TRUE(walls[1] && walls[2]);
  EXPECT_TRUE(walls[1]->is_inside);
  EXPECT_NEAR(walls[1]->radius_m, 0.05, 1e-4);
  EXPECT_NEAR(walls[1]->rim_m, 0.075, 1e-4);
  EXPECT_NEAR(walls[1]->foot_m, 0.015, 1e-4);
  EXPECT_NEAR((walls[1]->center - walls[2]->center).norm(), 0, 1e-3);
}

TEST(FindRoundWalls, TellsTheOutside) {
  const Cup outside(-1);
  const auto wall = FindRoundWalls(outside.grid, outside.labels, kUp, kMaxRadius_m)[1];
  ASSERT_TRUE(wall);
  EXPECT_FALSE(wall->is_inside);
  EXPECT_NEAR(wall->radius_m, 0.05, 1e-4);
}

TEST(FindRoundWalls, FindsNoneBeyondTheRadius) {
  const Cup cup;
  EXPECT_FALSE(FindRoundWalls(cup.grid, cup.labels, kUp, 0.04)[1]);
}

std::size_t NumMerged(const Cup& cup, double max_radius_m = kMaxRadius_m) {
  const RoundWalls walls = FindRoundWalls(cup.grid, cup.labels, kUp, max_radius_m);
  return CountLabels(MergeRoundWalls(cup.labels, walls));
}

TEST(MergeRoundWalls, JoinsInsideWithInsideAndOutside) {
  EXPECT_EQ(NumMerged(Cup()), 1U);
  EXPECT_EQ(NumMerged(Cup(-1, 1, 0)), 1U);
}

TEST(MergeRoundWalls, KeepsApartWallsThatStandBesideEachOther) {
  EXPECT_EQ(NumMerged(Cup(1, 0.04F)), 2U);
  EXPECT_EQ(NumMerged(Cup(-1, 1, 0.04F)), 2U);
}

TEST(MergeRoundWalls, LeavesWhatIsOnlySeenFromOutside) { EXPECT_EQ(NumMerged(Cup(-1)), 2U); }

TEST(MergeRoundWalls, IsOffAtZero) { EXPECT_EQ(NumMerged(Cup(), 0), 2U); }

}  // namespace
}  // namespace fovea
