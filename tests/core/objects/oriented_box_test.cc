#include "core/objects/oriented_box.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace fovea {
namespace {

// The surface points of a box of the given size, rotated about its vertical axis by `angle`,
// standing at `bottom`; up is -y of the camera.
std::vector<Eigen::Vector3f> BoxPoints(const Eigen::Vector3f& size, float angle,
                                       const Eigen::Vector3f& bottom) {
  const Eigen::AngleAxisf turn(angle, Eigen::Vector3f::UnitY());
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const float x = (static_cast<float>(i) / 20 - 0.5F) * size.x();
      const float z = (static_cast<float>(j) / 20 - 0.5F) * size.y();
      for (const float height : {0.0F, size.z()}) {
        points.push_back(bottom + turn * Eigen::Vector3f(x, -height, z));
      }
    }
  }
  return points;
}

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();
const SupportSurface kTable{kUp, 0.5F, 1};  // at y = 0.5

TEST(FitOrientedBox, RecoversATurnedBox) {
  for (const float angle : {0.0F, 0.3F, 0.8F, 1.4F}) {
    const auto points = BoxPoints({0.2F, 0.1F, 0.05F}, angle, {0.1F, 0.5F, 1});
    const OrientedBox box = FitOrientedBox(points, kUp, kTable);
    EXPECT_TRUE(box.size_m.isApprox(Eigen::Vector3f(0.2F, 0.1F, 0.05F), 1e-3F)) << box.size_m;
    EXPECT_TRUE(box.center.isApprox(Eigen::Vector3f(0.1F, 0.475F, 1), 1e-3F));
    EXPECT_NEAR(std::abs(box.rotation.col(0).x()), std::cos(angle), 1e-3F);
    EXPECT_EQ(Eigen::Vector3f(box.rotation.col(2)), kUp);
    EXPECT_NEAR(box.rotation.determinant(), 1, 1e-5F);
  }
}

TEST(FitOrientedBox, LosesNoCornerOfWhatIsHuge) {
  for (int i = 0; i < 1000; ++i) {
    const Eigen::AngleAxisf turn(static_cast<float>(i) * 0.00157F, Eigen::Vector3f::UnitY());
    std::vector<Eigen::Vector3f> points = {turn * Eigen::Vector3f(20, 1, 10)};
    for (const float x : {-300.0F, 300.0F}) {
      for (const float z : {-150.0F, 150.0F}) points.emplace_back(turn * Eigen::Vector3f(x, 0, z));
    }
    const OrientedBox box = FitOrientedBox(points, kUp, std::nullopt);
    EXPECT_TRUE(box.size_m.isApprox(Eigen::Vector3f(600, 300, 1), 1e-3F)) << box.size_m;
  }
}

TEST(FitOrientedBox, GivesASquareFootprintItsSideAndNotItsDiagonal) {
  const auto points = BoxPoints({0.1F, 0.1F, 0.1F}, 0.6F, {0, 0.5F, 1});
  EXPECT_NEAR(FitOrientedBox(points, kUp, kTable).size_m.x(), 0.1F, 1e-3F);
}

TEST(FitOrientedBox, ReachesDownToANearSupportOnly) {
  const auto near = BoxPoints({0.1F, 0.1F, 0.1F}, 0, {0, 0.48F, 1});
  EXPECT_NEAR(FitOrientedBox(near, kUp, kTable).size_m.z(), 0.12F, 1e-4F);
  const auto stacked = BoxPoints({0.1F, 0.1F, 0.1F}, 0, {0, 0.4F, 1});
  EXPECT_NEAR(FitOrientedBox(stacked, kUp, kTable).size_m.z(), 0.1F, 1e-4F);
  EXPECT_NEAR(FitOrientedBox(near, kUp, std::nullopt).size_m.z(), 0.1F, 1e-4F);
}

TEST(FitOrientedBox, HoldsWhatLiesBelowTheSupport) {
  const auto noisy = BoxPoints({0.1F, 0.1F, 0.1F}, 0, {0, 0.51F, 1});  // down to 10 mm below it
  EXPECT_NEAR(FitOrientedBox(noisy, kUp, kTable).size_m.z(), 0.09F, 1e-4F);
  const auto beyond_the_edge = BoxPoints({0.1F, 0.1F, 0.1F}, 0, {0, 0.6F, 1});
  EXPECT_NEAR(FitOrientedBox(beyond_the_edge, kUp, kTable).size_m.z(), 0.1F, 1e-4F);
  const auto on_the_floor = BoxPoints({0.1F, 0.1F, 0.1F}, 0, {0, 0.9F, 1});
  EXPECT_NEAR(FitOrientedBox(on_the_floor, kUp, kTable).size_m.z(), 0.1F, 1e-4F);
}

TEST(FitOrientedBox, TakesASinglePoint) {
  const OrientedBox box = FitOrientedBox({{0, 0, 1}}, kUp, std::nullopt);
  EXPECT_EQ(box.center, Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(box.size_m, Eigen::Vector3f(0, 0, 0));
  EXPECT_TRUE(box.rotation.allFinite());
}

}  // namespace
}  // namespace fovea
