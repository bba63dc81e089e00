#include "core/scene/support_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace fovea {
namespace {

struct Cloud {
  std::vector<cv::Vec3f> points;
  std::vector<cv::Vec3f> normals;

  // A level square of n × n points around (0, y, 1.5); y points down.
  void AddLevel(float y, int n, float tilt = 0) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const float x = static_cast<float>(i) / static_cast<float>(n) - 0.5F;
        const float z = static_cast<float>(j) / static_cast<float>(n) + 1.0F;
        points.emplace_back(x, y + tilt * (z - 1.5F), z);
        normals.push_back(cv::normalize(cv::Vec3f(0, -1, tilt)));
      }
    }
  }
  // A level rectangle of one point a centimetre, its corner at (x, z).
  void AddRectangle(float y, float x, float z, int width_cm, int depth_cm) {
    for (int i = 0; i < width_cm; ++i) {
      for (int j = 0; j < depth_cm; ++j) {
        points.emplace_back(x + 0.01F * static_cast<float>(i), y,
                            z + 0.01F * static_cast<float>(j));
        normals.emplace_back(0, -1, 0);
      }
    }
  }
  void AddWall(int n) {
    for (int i = 0; i < n; ++i) {
      points.emplace_back(0.001F * static_cast<float>(i), 0.4F, 2.0F);
      normals.emplace_back(0, 0, -1);
    }
  }
  cv::Mat Points() const { return cv::Mat(points, true).reshape(3, 1); }
  cv::Mat Normals() const { return cv::Mat(normals, true).reshape(3, 1); }
};

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

TEST(FindSupports, TheShareIsAskedOfTheFirstOnly) {
  Cloud cloud;
  cloud.AddLevel(0.7F, 40);
  cloud.AddLevel(0.4F, 5);  // 25 of 1625 points
  EXPECT_EQ(FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.max_surfaces = 2}).size(), 2U);
}

TEST(FindSupports, LeavesOutWhatIsTooSmallToCarry) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1.0F, 100, 80);  // a table
  cloud.AddRectangle(0.6F, 0.0F, 1.2F, 12, 12);    // the top of a box on it
  cloud.AddRectangle(0.3F, -0.5F, 2.0F, 60, 30);   // a shelf
  SupportOptions options{.max_surfaces = 3, .min_area_m2 = 0.05};
  const auto supports = FindSupports(cloud.Points(), {cloud.Normals()}, kDown, options);
  ASSERT_EQ(supports.size(), 2U);
  EXPECT_NEAR(supports[0].surface.HeightOf({0, 0.7F, 1.5F}), 0.0F, 1e-4F);
  EXPECT_NEAR(supports[1].surface.HeightOf({0, 0.3F, 2.1F}), 0.0F, 1e-4F);
  EXPECT_TRUE(supports[1].footprint.Covers({3, 0.3F, 5}));  // no margin: everywhere above it
  options.min_area_m2 = 0;
  EXPECT_EQ(FindSupports(cloud.Points(), {cloud.Normals()}, kDown, options).size(), 3U);
}

// Side by side, boxes have tops as large as a small shelf.
TEST(FindSupports, TopsInTheHeightOfObjectsMustBeLargerToCarry) {
  const auto count = [](float height_m, int depth_cm) {
    Cloud cloud;
    cloud.AddRectangle(0.7F, -0.5F, 1, 100, 100);
    cloud.AddRectangle(0.7F - height_m, -0.2F, 1.2F, 40, depth_cm);
    return FindSupports(cloud.Points(), {cloud.Normals()}, kDown,
                        {.max_surfaces = 2, .min_area_m2 = 0.05})
        .size();
  };
  EXPECT_EQ(count(0.2F, 30), 1U) << "0.12 m² of 0.2 m² are a top";
  EXPECT_EQ(count(0.2F, 70), 2U) << "0.28 m² are a shelf";
  EXPECT_EQ(count(0.5F, 30), 2U) << "no object is that high";
}

TEST(FindSupports, AMarginBoundsTheFootprints) {
  Cloud cloud;
  cloud.AddRectangle(0.7F, -0.5F, 1.0F, 100, 80);
  const auto supports =
      FindSupports(cloud.Points(), {cloud.Normals()}, kDown, {.footprint_margin_m = 0.06});
  ASSERT_EQ(supports.size(), 1U);
  EXPECT_TRUE(supports[0].footprint.Covers({0.53F, 0.6F, 1.4F}));
  EXPECT_FALSE(supports[0].footprint.Covers({0.65F, 0.6F, 1.4F}));
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
