#include "core/scene/support_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tests/core/scene/cloud.h"

namespace fovea {
namespace {

const Eigen::Vector3f kDown = Eigen::Vector3f::UnitY();

std::optional<SupportSurface> Dominating(const cv::Mat& points, const cv::Mat& normals,
                                         const Eigen::Vector3f& gravity,
                                         const SupportOptions& options = {}) {
  const std::vector<Support> supports = FindSupports(points, {normals}, gravity, options);
  return supports.empty() ? std::nullopt : std::optional(supports.front().surface);
}

TEST(FindSupports, TakesTheHeightOfMostLevelPoints) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 40);
  cloud.AddLevel(0.4F, 20);
  cloud.AddWall(5000);  // many points, but not level
  const auto surface = Dominating(cloud.Points(), cloud.Normals(), kDown);
  ASSERT_TRUE(surface.has_value());
  EXPECT_NEAR(surface->HeightOf({0.1F, 0.7F, 1.2F}), 0.0F, 1e-4F);
  EXPECT_NEAR(surface->HeightOf({0.1F, 0.6F, 1.2F}), 0.1F, 1e-4F);  // above is positive
  EXPECT_EQ(surface->num_points, 1600U);
}

TEST(FindSupports, FollowsASlightTiltByLeastSquares) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 60, 0.01F);
  const auto fitted = Dominating(cloud.Points(), cloud.Normals(), kDown);
  ASSERT_TRUE(fitted.has_value());
  EXPECT_NEAR(fitted->HeightOf({0, 0.705F, 2.0F}), 0.0F, 1e-3F);
  const auto level = Dominating(cloud.Points(), cloud.Normals(), kDown, {.plane_fits = 0});
  ASSERT_TRUE(level.has_value());
  EXPECT_EQ(level->normal, Eigen::Vector3f(-kDown));
}

TEST(FindSupports, IsAbsentWhereNothingIsLevelOrTooLittle) {
  Cloud walls;
  walls.AddWall(1000);
  EXPECT_FALSE(Dominating(walls.Points(), walls.Normals(), kDown).has_value());
  walls.AddLevel(0.7F, 5);  // 25 of 1025 points
  EXPECT_FALSE(Dominating(walls.Points(), walls.Normals(), kDown).has_value());
  Cloud ramp;
  ramp.AddLevel(0.7F, 40, 0.5F);  // 27°
  EXPECT_FALSE(Dominating(ramp.Points(), ramp.Normals(), kDown).has_value());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat none(3, 3, CV_32FC3, cv::Scalar::all(nan));
  EXPECT_FALSE(Dominating(none, none, kDown).has_value());
}

TEST(FindSupports, FindsSeveralTheFullestFirst) {
  Cloud cloud;
  cloud.AddLevel(0.4F, 20);
  cloud.AddLevel(0.7F, 40);
  cloud.AddLevel(0.1F, 30);
  const auto supports = FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 5});
  ASSERT_EQ(supports.size(), 3U);
  EXPECT_NEAR(supports[0].surface.HeightOf({0, 0.7F, 1.5F}), 0.0F, 1e-4F);
  EXPECT_NEAR(supports[1].surface.HeightOf({0, 0.1F, 1.5F}), 0.0F, 1e-4F);
  EXPECT_NEAR(supports[2].surface.HeightOf({0, 0.4F, 1.5F}), 0.0F, 1e-4F);
  EXPECT_EQ(supports[1].surface.num_points, 900U);
  EXPECT_EQ(FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 2}).size(), 2U);
}

TEST(FindSupports, NoiseAroundASurfaceIsNoOther) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 40);
  cloud.AddLevel(0.685F, 20);  // one and a half tolerances above it
  EXPECT_EQ(FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 2}).size(), 1U);
}

// Of 5° that gravity is off by, the first surface tells.
TEST(FindSupports, TheFirstIsTheVerticalOfTheOthers) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 60, 0.09F);
  cloud.AddLevel(0.3F, 20, 0.09F);
  cloud.AddLevel(0.1F, 12);  // as gravity has it, more of this is at one height
  const auto supports = FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 2});
  ASSERT_EQ(supports.size(), 2U);
  EXPECT_EQ(supports[1].surface.num_points, 400U);
}

TEST(FindSupports, TheShareIsAskedOfTheFirstOnly) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 40);
  cloud.AddLevel(0.4F, 5);  // 25 of 1625 points
  EXPECT_EQ(FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 2}).size(), 2U);
}

// A floor at y = 1, everywhere, and a table top at y = 0.3 over x -0.5 … 0.5, z 1 … 1.8.
std::vector<Support> FloorAndTable() {
  const SupportSurface floor{-kDown, 1.0F, 1};
  const SupportSurface table{-kDown, 0.3F, 1};
  std::vector<Eigen::Vector3f> on_table;
  for (int i = 0; i <= 50; ++i) {
    for (int j = 0; j <= 40; ++j) {
      on_table.emplace_back(-0.5F + 0.02F * static_cast<float>(i), 0.3F,
                            1 + 0.02F * static_cast<float>(j));
    }
  }
  return {{floor, Footprint()}, {table, Footprint(on_table, {}, table, 0.0, 0.0)}};
}

TEST(SupportBelow, IsTheNearestThatCoversThePoint) {
  const auto supports = FloorAndTable();
  EXPECT_EQ(SupportBelow(supports, {0, 0.2F, 1.4F}, {}), 1U);     // over the table
  EXPECT_EQ(SupportBelow(supports, {0, 0.6F, 1.4F}, {}), 0U);     // under it
  EXPECT_EQ(SupportBelow(supports, {0.8F, 0.2F, 1.4F}, {}), 0U);  // beside it
  const std::vector<Support> swapped{supports[1], supports[0]};
  EXPECT_EQ(SupportBelow(swapped, {0, 0.2F, 1.4F}, {}), 0U);
}

TEST(SupportBelow, IsNoneOnASurfaceAndBelowAll) {
  const auto supports = FloorAndTable();
  const SupportOptions options{.tolerance_m = 0.01};
  for (const float offset : {-0.008F, 0.0F, 0.008F}) {
    EXPECT_EQ(SupportBelow(supports, {0, 0.3F + offset, 1.4F}, options), std::nullopt) << offset;
    EXPECT_EQ(SupportBelow(supports, {0.8F, 1.0F + offset, 1.4F}, options), std::nullopt);
  }
  EXPECT_EQ(SupportBelow(supports, {0, 0.288F, 1.4F}, options), 1U);  // 12 mm above
  EXPECT_EQ(SupportBelow(supports, {0, 0.312F, 1.4F}, options), 0U);  // 12 mm below
  EXPECT_EQ(SupportBelow(supports, {0, 1.1F, 1.4F}, options), std::nullopt);
}

TEST(SupportBelow, BeginsAtAShareOfTheTolerance) {
  std::vector<Support> supports = FloorAndTable();
  supports[1].tolerance_share = 0.5F;
  const SupportOptions options{.tolerance_m = 0.01};
  EXPECT_EQ(SupportBelow(supports, {0, 0.296F, 1.4F}, options), std::nullopt);  // 4 mm above
  EXPECT_EQ(SupportBelow(supports, {0, 0.294F, 1.4F}, options), 1U);
  EXPECT_EQ(SupportBelow(supports, {0, 0.308F, 1.4F}, options), std::nullopt);  // 8 mm below
}

TEST(SupportBelow, BeginsFartherAboveWhatScattersMuch) {
  std::vector<Support> supports = FloorAndTable();
  supports[1].tolerance_share = 2;
  const SupportOptions options{.tolerance_m = 0.01};
  for (const float offset : {-0.018F, 0.018F}) {
    EXPECT_EQ(SupportBelow(supports, {0, 0.3F + offset, 1.4F}, options), std::nullopt) << offset;
    EXPECT_TRUE(IsOnSupport(supports, {0, 0.3F + offset, 1.4F}, options)) << offset;
  }
  EXPECT_EQ(SupportBelow(supports, {0, 0.278F, 1.4F}, options), 1U);
  EXPECT_FALSE(IsOnSupport(supports, {0, 0.278F, 1.4F}, options));
}

TEST(FindSupports, LetsThingsStandCloserOnWhatScattersLittle) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 60);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    cloud.points[i][1] += i % 2 == 0 ? 0.002F : -0.002F;
  }
  const auto share = [&](double sigmas) {
    const auto supports =
        FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.tolerance_sigmas = sigmas});
    return supports.at(0).tolerance_share;
  };
  EXPECT_EQ(share(0), 1);
  EXPECT_NEAR(share(2.5), 2.5 * 0.2 / 0.6745, 0.01);
}

TEST(FindSupports, WhatIsTellablyAboveASurfaceIsNoPartOfIt) {
  Cloud cloud;
  cloud.AddRectangle(0.705F, -0.5F, 1.0F, 100, 80);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    cloud.points[i][1] += i % 2 == 0 ? 0.001F : -0.001F;
  }
  cloud.AddRectangle(0.697F, 1.5F, 1.0F, 30, 30);  // 8 mm higher, within the tolerance
  SupportOptions options{.plane_fits = 0, .min_area_m2 = 0.02, .footprint_margin_m = 0.01};
  const auto covers = [&] {
    const auto supports = FindSupports(cloud.Points(), {cloud.Normals()}, kDown, options);
    return supports.at(0).footprint.Covers({1.65F, 0.6F, 1.15F});
  };
  EXPECT_TRUE(covers());
  options.tolerance_sigmas = 2.5;
  EXPECT_FALSE(covers());
}

TEST(SupportBelow, IsNoneBesideOrTooHighAbove) {
  const std::vector<Support> table{FloorAndTable()[1]};
  EXPECT_EQ(SupportBelow(table, {0.8F, 0.2F, 1.4F}, {}), std::nullopt);
  const SupportOptions options{.max_height_m = 0.5};
  EXPECT_EQ(SupportBelow(table, {0, -0.19F, 1.4F}, options), 0U);
  EXPECT_EQ(SupportBelow(table, {0, -0.21F, 1.4F}, options), std::nullopt);
  EXPECT_EQ(SupportBelow({}, {0, 0.2F, 1.4F}, {}), std::nullopt);
}

TEST(SupportTolerance, GrowsWithTheSquareOfTheDistance) {
  const SupportOptions options{.tolerance_m = 0.004, .tolerance_per_m = 0.006};
  EXPECT_FLOAT_EQ(SupportTolerance(2.0F, options), 0.004F + 0.006F * 4);
}

}  // namespace
}  // namespace fovea
