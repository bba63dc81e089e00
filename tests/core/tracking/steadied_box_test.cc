#include "core/tracking/steadied_box.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace fovea {
namespace {

OrientedBox Box(float x, float yaw_deg, const Eigen::Vector3f& size) {
  OrientedBox box;
  box.center = {x, 0, 1};
  box.rotation =
      Eigen::AngleAxisf(yaw_deg * EIGEN_PI / 180, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  box.size_m = size;
  return box;
}

float YawOf(const OrientedBox& box) {
  return std::atan2(box.rotation(1, 0), box.rotation(0, 0)) * 180 / static_cast<float>(EIGEN_PI);
}

TEST(SteadiedBox, IsTheMean) {
  SteadiedBox steadied(Box(0, 0, {0.3F, 0.2F, 0.1F}));
  steadied.Add(Box(0.03F, 10, {0.36F, 0.2F, 0.1F}));
  steadied.Add(Box(0.03F, 5, {0.3F, 0.2F, 0.13F}));
  EXPECT_NEAR(steadied.mean().center.x(), 0.02, 1e-6);
  EXPECT_NEAR(YawOf(steadied.mean()), 5, 1e-3);
  EXPECT_TRUE(steadied.mean().size_m.isApprox(Eigen::Vector3f(0.32F, 0.2F, 0.11F), 1e-5F));
  EXPECT_EQ(steadied.count(), 3U);
}

TEST(SteadiedBox, ABoxTurnedByAQuarterOrAHalfIsTheSame) {
  SteadiedBox steadied(Box(0, 2, {0.21F, 0.2F, 0.1F}));
  steadied.Add(Box(0, 90, {0.21F, 0.19F, 0.1F}));
  EXPECT_NEAR(YawOf(steadied.mean()), 1, 1e-3);
  EXPECT_TRUE(steadied.mean().size_m.isApprox(Eigen::Vector3f(0.2F, 0.205F, 0.1F), 1e-5F));
  steadied.Add(Box(0, 181, {0.2F, 0.205F, 0.1F}));
  EXPECT_NEAR(YawOf(steadied.mean()), 1, 1e-3);
  EXPECT_NEAR(steadied.mean().rotation.determinant(), 1, 1e-5);
}

TEST(SteadiedBox, StartsAnewWithTheSameSideAlongX) {
  SteadiedBox steadied(Box(0, 2, {0.21F, 0.2F, 0.1F}));
  steadied.Add(Box(0, 2, {0.21F, 0.2F, 0.1F}));
  steadied.StartAnew(Box(0.5F, 93, {0.3F, 0.2F, 0.1F}));
  EXPECT_EQ(steadied.count(), 1U);
  EXPECT_NEAR(YawOf(steadied.mean()), 3, 1e-3);
  EXPECT_TRUE(steadied.mean().size_m.isApprox(Eigen::Vector3f(0.2F, 0.3F, 0.1F), 1e-5F));
  EXPECT_NEAR(steadied.mean().center.x(), 0.5, 1e-6);
}

TEST(SteadiedBox, OldFramesFade) {
  SteadiedBox steadied(Box(1, 0, {0.3F, 0.2F, 0.1F}));
  for (int i = 0; i < 60; ++i) steadied.Add(Box(0, 0, {0.3F, 0.2F, 0.1F}));
  EXPECT_EQ(steadied.count(), SteadiedBox::kSteadiedOver);
  EXPECT_LT(steadied.mean().center.x(), 0.001);
}

}  // namespace
}  // namespace fovea
