// How much of a surface must be seen, and where things may stand on it.
#include <gtest/gtest.h>

#include <vector>

#include "core/scene/support_surface.h"
#include "tests/core/scene/cloud.h"

namespace fovea {
namespace {

const Eigen::Vector3f kGravity = Eigen::Vector3f::UnitY();

std::vector<Support> SupportsIn(const Cloud& cloud, const SupportOptions& options) {
  return FindSupports(cloud.Points(), {cloud.Normals()}, kGravity, options);
}

TEST(FindSupports, LeavesOutWhatIsTooSmallToCarry) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1.0F, 100, 80);  // a table
  cloud.AddRectangle(0.6F, 0.0F, 1.2F, 12, 12);    // the top of a box on it
  cloud.AddRectangle(0.3F, -0.5F, 2.0F, 60, 30);   // a shelf
  SupportOptions options{.max_surfaces = 3, .min_area_m2 = 0.05};
  const auto supports = SupportsIn(cloud, options);
  ASSERT_EQ(supports.size(), 2U);
  EXPECT_NEAR(supports[0].surface.HeightOf({0, 0.7F, 1.5F}), 0.0F, 1e-4F);
  EXPECT_NEAR(supports[1].surface.HeightOf({0, 0.3F, 2.1F}), 0.0F, 1e-4F);
  EXPECT_TRUE(supports[1].footprint.Covers({3, 0.3F, 5}));  // no margin: everywhere above it
  options.min_area_m2 = 0;
  EXPECT_EQ(SupportsIn(cloud, options).size(), 3U);
}

// Close to the camera, where the tolerance is less than the interval of heights.
TEST(FindSupports, LeavesOutWhatNoPointLiesOn) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.3F, 0.3F, 60, 30);
  // Between two things most points have heights next to that of one, which is not in its middle.
  cloud.AddRectangle(0.305F, -0.1F, 0.3F, 5, 4);
  cloud.AddRectangle(0.2903F, 0, 0.3F, 1, 1);
  cloud.AddRectangle(0.285F, 0.1F, 0.3F, 5, 4);
  const auto supports = SupportsIn(cloud, {.tolerance_m = 0.004,
                                           .tolerance_per_m = 0.006,
                                           .max_surfaces = 4,
                                           .footprint_margin_m = 0.1});
  EXPECT_EQ(supports.size(), 3U);
  for (const Support& support : supports) EXPECT_GT(support.surface.num_points, 0U);
}

// Side by side, boxes have tops as large as a small shelf.
TEST(FindSupports, TopsInTheHeightOfObjectsMustBeLargerToCarry) {
  const auto count = [](float height_m, int depth_cm) {
    Cloud cloud;
    cloud.AddRectangle(0.7F, -0.5F, 1, 100, 100);
    cloud.AddRectangle(0.7F - height_m, -0.2F, 1.2F, 40, depth_cm);
    return SupportsIn(cloud, {.max_surfaces = 2, .min_area_m2 = 0.05}).size();
  };
  EXPECT_EQ(count(0.2F, 30), 1U) << "0.12 m² of 0.2 m² are a top";
  EXPECT_EQ(count(0.2F, 70), 2U) << "0.28 m² are a shelf";
  EXPECT_EQ(count(0.5F, 30), 2U) << "no object is that high";
  EXPECT_EQ(count(-0.2F, 30), 2U) << "it lies lower";
}

// With a margin a support is known to end.
TEST(FindSupports, WhatLiesBesideASupportIsNoTop) {
  const auto count = [](float x) {
    Cloud cloud;
    cloud.AddRectangle(0.7F, -0.5F, 1, 100, 100);
    cloud.AddRectangle(0.5F, x, 1.2F, 40, 30);
    return SupportsIn(cloud, {.max_surfaces = 2, .min_area_m2 = 0.05, .footprint_margin_m = 0.05})
        .size();
  };
  EXPECT_EQ(count(0.7F), 2U);
  EXPECT_EQ(count(0.4F), 2U) << "three eighths of it lie over the other one";
  EXPECT_EQ(count(0.2F), 1U);
}

TEST(FindSupports, PartsThatAreTooSmallCarryNothingTogether) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1, 100, 80);
  cloud.AddRectangle(0.1F, -0.4F, 1.2F, 16, 16);  // tops of two cupboards
  cloud.AddRectangle(0.1F, 0.2F, 1.2F, 16, 16);
  EXPECT_EQ(SupportsIn(cloud, {.max_surfaces = 2, .min_area_m2 = 0.05}).size(), 1U);
  EXPECT_EQ(SupportsIn(cloud, {.max_surfaces = 2, .min_area_m2 = 0.02}).size(), 2U);
}

// What stands on a table may part what is seen of it, a lamp above it and noise do not.
TEST(FindSupports, ThingsJoinThePartsOfASurface) {
  const auto count = [](float height_m) {
    Cloud cloud;
    cloud.AddRectangle(0.7F, -0.3F, 1, 20, 20);
    cloud.AddRectangle(0.7F, 0.1F, 1, 20, 20);
    const std::size_t num_level = cloud.points.size();
    for (int i = 0; i < 4; ++i) cloud.AddRectangle(0.7F - height_m, -0.1F, 1, 20, 20);
    for (std::size_t p = num_level; p < cloud.points.size(); ++p) cloud.normals[p] = {0, 0, -1};
    return SupportsIn(cloud, {.min_area_m2 = 0.06, .max_height_m = 0.5}).size();
  };
  EXPECT_EQ(count(0.2F), 1U);
  EXPECT_EQ(count(0.6F), 0U);
  EXPECT_EQ(count(0.008F), 0U);
}

// Close to the camera, a small thing has more points than a shelf.
TEST(FindSupports, LooksPastWhatIsTooSmall) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1, 100, 80);
  for (int i = 0; i < 20; ++i) cloud.AddRectangle(0.6F, 0, 1.2F, 12, 12);
  cloud.AddRectangle(0.3F, -0.5F, 2, 60, 30);
  EXPECT_EQ(SupportsIn(cloud, {.max_surfaces = 2, .min_area_m2 = 0.05}).size(), 2U);
}

TEST(FindSupports, AMarginBoundsTheFootprints) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1.0F, 100, 80);
  const auto supports = SupportsIn(cloud, {.footprint_margin_m = 0.06});
  ASSERT_EQ(supports.size(), 1U);
  EXPECT_TRUE(supports[0].footprint.Covers({0.53F, 0.6F, 1.4F}));
  EXPECT_FALSE(supports[0].footprint.Covers({0.65F, 0.6F, 1.4F}));
}

}  // namespace
}  // namespace fovea
