#include "core/scene/support_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
  const std::vector<Support> supports = FindSupports(points, normals, gravity, options);
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

TEST(SupportTolerance, GrowsWithTheSquareOfTheDistance) {
  const SupportOptions options{.tolerance_m = 0.004, .tolerance_per_m = 0.006};
  EXPECT_FLOAT_EQ(SupportTolerance(2.0F, options), 0.004F + 0.006F * 4);
}

}  // namespace
}  // namespace fovea
