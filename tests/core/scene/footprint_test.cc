#include "core/scene/footprint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

namespace fovea {
namespace {

using Points = std::vector<Eigen::Vector3f>;

// Level, at y = 0.7; y points down.
const SupportSurface kTable{-Eigen::Vector3f::UnitY(), 0.7F, 0};

// Adds one point a centimetre over [x0, x1] × [z0, z1]; centimetres.
void AddRectangle(int x0, int x1, int z0, int z1, Points& points) {
  for (int x = x0; x <= x1; ++x) {
    for (int z = z0; z <= z1; ++z) {
      points.emplace_back(0.01F * static_cast<float>(x), 0.7F, 0.01F * static_cast<float>(z));
    }
  }
}

// 60 × 60 cm around (0, 1.3), of which the middle 30 × 30 cm is not seen.
Points Ring() {
  Points points;
  AddRectangle(-30, 30, 100, 115, points);
  AddRectangle(-30, 30, 145, 160, points);
  AddRectangle(-30, -15, 115, 145, points);
  AddRectangle(15, 30, 115, 145, points);
  return points;
}

TEST(Footprint, IsUnboundedByDefault) {
  EXPECT_TRUE(Footprint().Covers({0, 0, 1}));
  EXPECT_TRUE(Footprint().Covers({-50, 3, 100}));
  EXPECT_EQ(Footprint().AreaM2(), 0);
}

TEST(Footprint, CoversAHiddenMiddleButNotTheOutside) {
  const Footprint footprint(Ring(), {}, kTable, 0, 0);
  EXPECT_TRUE(footprint.Covers({0.28F, 0.7F, 1.3F}));  // seen
  EXPECT_TRUE(footprint.Covers({0, 0.7F, 1.3F}));      // hidden
  EXPECT_TRUE(footprint.Covers({0, 0.2F, 1.3F}));      // above the hidden
  for (const Eigen::Vector2f& outside :
       {Eigen::Vector2f(0.35F, 1.3F), {-0.35F, 1.3F}, {0, 0.95F}, {0, 1.65F}, {9, 9}, {-9, -9}}) {
    EXPECT_FALSE(footprint.Covers({outside.x(), 0.7F, outside.y()})) << outside.transpose();
  }
}

TEST(Footprint, DoesNotReachWhereNoCellCanBe) {
  const Footprint footprint(Ring(), {}, kTable, 0, 0);
  for (const float far_m : {1e9F, 1e30F, std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_FALSE(footprint.Covers({far_m, 0.7F, far_m})) << far_m;
    EXPECT_FALSE(footprint.Covers({-far_m, 0.7F, -far_m})) << far_m;
  }
}

TEST(Footprint, CoversTheNookOfAnL) {
  Points corner;
  AddRectangle(0, 60, 100, 110, corner);
  AddRectangle(0, 10, 100, 160, corner);
  const Footprint footprint(corner, {}, kTable, 0, 0);
  EXPECT_TRUE(footprint.Covers({0.25F, 0.7F, 1.25F}));
  EXPECT_FALSE(footprint.Covers({0.5F, 0.7F, 1.5F}));  // beyond the line between the ends
}

TEST(Footprint, AreaIsWhatIsSeen) {
  Points square;
  AddRectangle(-30, 30, 100, 160, square);
  constexpr double kCell = 0.02;  // up to one cell too many along the outlines
  EXPECT_NEAR(Footprint(square, {}, kTable, 0, 0).AreaM2(), 0.36, 2.4 * kCell);
  EXPECT_NEAR(Footprint(square, {}, kTable, 0, 0.2).AreaM2(), 0.36, 2.4 * kCell);  // without margin
  EXPECT_NEAR(Footprint(Ring(), {}, kTable, 0, 0).AreaM2(), 0.36 - 0.09, (2.4 + 1.2) * kCell);
}

TEST(Footprint, LeavesSmallPartsOut) {
  Points points;
  AddRectangle(0, 60, 100, 160, points);     // 0.36 m²
  AddRectangle(150, 160, 100, 110, points);  // 0.01 m²
  const Eigen::Vector3f on_small(1.55F, 0.7F, 1.05F);
  const Footprint all(points, {}, kTable, 0, 0);
  EXPECT_TRUE(all.Covers(on_small));
  EXPECT_FALSE(all.Covers({1.0F, 0.7F, 1.05F})) << "each part has its own hull";
  const Footprint large(points, {}, kTable, 0.05, 0);
  EXPECT_FALSE(large.Covers(on_small));
  EXPECT_TRUE(large.Covers({0.3F, 0.7F, 1.3F}));
  EXPECT_NEAR(all.AreaM2() - large.AreaM2(), 0.01, 0.005);
  const Footprint none(points, {}, kTable, 1, 0);
  EXPECT_FALSE(none.Covers({0.3F, 0.7F, 1.3F}));
  EXPECT_EQ(none.AreaM2(), 0);
}

TEST(Footprint, APileDoesNotPartASurface) {
  Points left_and_right;
  AddRectangle(0, 40, 100, 160, left_and_right);   // 0.24 m²
  AddRectangle(70, 80, 100, 160, left_and_right);  // 0.06 m²
  Points pile;
  AddRectangle(41, 69, 110, 130, pile);
  for (Eigen::Vector3f& point : pile) point.y() -= 0.2F;
  const Eigen::Vector3f between(0.55F, 0.7F, 1.5F), right(0.75F, 0.7F, 1.5F);
  const Footprint parted(left_and_right, {}, kTable, 0.1, 0);
  EXPECT_FALSE(parted.Covers(between));
  EXPECT_FALSE(parted.Covers(right));
  const Footprint whole(left_and_right, pile, kTable, 0.1, 0);
  EXPECT_TRUE(whole.Covers(between));
  EXPECT_TRUE(whole.Covers(right));
  EXPECT_NEAR(whole.AreaM2(), 0.3, 0.04) << "the surface without the pile";
}

TEST(Footprint, WhatStandsBesideASurfaceIsNoPartOfIt) {
  Points table, beside;
  AddRectangle(0, 40, 100, 160, table);
  AddRectangle(41, 90, 100, 160, beside);
  for (Eigen::Vector3f& point : beside) point.y() -= 0.3F;
  const Footprint footprint(table, beside, kTable, 0, 0);
  EXPECT_TRUE(footprint.Covers({0.3F, 0.7F, 1.3F}));
  EXPECT_FALSE(footprint.Covers({0.5F, 0.7F, 1.3F}));
}

TEST(Footprint, GrowsByTheMargin) {
  Points square;
  AddRectangle(-30, 30, 100, 160, square);
  const Footprint footprint(square, {}, kTable, 0, 0.1);
  for (const float side : {-1.0F, 1.0F}) {
    EXPECT_TRUE(footprint.Covers({side * 0.38F, 0.7F, 1.3F})) << side;
    EXPECT_FALSE(footprint.Covers({side * 0.44F, 0.7F, 1.3F})) << side;
    EXPECT_TRUE(footprint.Covers({0, 0.7F, 1.3F + side * 0.38F})) << side;
    EXPECT_FALSE(footprint.Covers({0, 0.7F, 1.3F + side * 0.44F})) << side;
  }
}

TEST(Footprint, ClosesGapsOfThinSampling) {
  Points thin;
  for (int i = 0; i <= 15; ++i) {
    for (int j = 0; j <= 15; ++j) {
      thin.emplace_back(0.04F * static_cast<float>(i), 0.7F, 1 + 0.04F * static_cast<float>(j));
    }
  }
  EXPECT_NEAR(Footprint(thin, {}, kTable, 0.1, 0).AreaM2(), 0.36, 0.04);
}

TEST(Footprint, ProjectsAlongTheNormalOfATiltedSurface) {
  const Eigen::Quaternionf turn(
      Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 0.3F, -0.2F).normalized()));
  const SupportSurface tilted{turn * kTable.normal, kTable.offset_m, 0};
  Points points = Ring();
  for (Eigen::Vector3f& point : points) point = turn * point;
  const Footprint footprint(points, {}, tilted, 0, 0);
  EXPECT_TRUE(footprint.Covers(turn * Eigen::Vector3f(0, 0.2F, 1.3F)));
  EXPECT_TRUE(footprint.Covers(turn * Eigen::Vector3f(0.25F, 0.2F, 1.3F)));
  EXPECT_FALSE(footprint.Covers(turn * Eigen::Vector3f(0.36F, 0.2F, 1.3F)));
}

TEST(Footprint, StaysSmallHoweverFarThePointsReach) {
  Points points = Ring();
  points.emplace_back(2e4F, 0.7F, 3e4F);
  const Footprint footprint(points, {}, kTable, 0, 0.1);
  EXPECT_TRUE(footprint.Covers({0, 0.7F, 1.3F}));
  EXPECT_FALSE(footprint.Covers({5e3F, 0.7F, 5e3F}));
}

}  // namespace
}  // namespace fovea
