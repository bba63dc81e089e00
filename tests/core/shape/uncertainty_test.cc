#include "core/shape/uncertainty.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

Solid KnownBox() {
  Solid box;
  box.half_length_m = 0.1F;
  box.half_width_m = 0.06F;
  box.height_m = 0.15F;
  return box;
}

// A grid of points on the front of the box at y = -0.06, and on its top too where that is seen; a
// camera before it, level with its middle or above.
SeenObject SeenFrom(float camera_h, float noise_m, bool with_top) {
  const int side = 10, count = side * side * (with_top ? 2 : 1);
  SeenObject seen;
  seen.camera = {0, -1, camera_h};
  seen.points = LevelPoints(count);
  for (int i = 0; i < count; ++i) {
    const bool is_top = i >= side * side;
    const float along = (static_cast<float>(i % side) + 0.5F) / side;
    const float across = (static_cast<float>(i / side % side) + 0.5F) / side;
    seen.points.x[i] = 0.2F * along - 0.1F;
    seen.points.y[i] = is_top ? 0.12F * across - 0.06F : -0.06F;
    seen.points.h[i] = is_top ? 0.15F : 0.15F * across;
  }
  seen.noise_m = SeenArray::Constant(count, noise_m);
  return seen;
}

TEST(Uncertainty, IsLargeOfWhatIsHidden) {
  const BoxUncertainty front = UncertaintyOf(SeenFrom(0.08F, 0.003F, false), KnownBox(), 0.1F);
  // Nothing tells how far it reaches back.
  EXPECT_GT(front.size_sigma_m.y(), 0.03F);
  EXPECT_GT(std::sqrt(front.pose_covariance(1, 1)), 0.015F);
  EXPECT_LT(front.size_sigma_m.y(), 0.2F);
  const BoxUncertainty both = UncertaintyOf(SeenFrom(0.8F, 0.003F, true), KnownBox(), 0.1F);
  // The top does not end the box either, but it is seen to be at 15 cm.
  EXPECT_LT(both.size_sigma_m.z(), front.size_sigma_m.z());
  EXPECT_LT(both.pose_covariance(2, 2), front.pose_covariance(2, 2));
}

TEST(Uncertainty, GrowsWithTheNoise) {
  const BoxUncertainty clear = UncertaintyOf(SeenFrom(0.8F, 0.002F, true), KnownBox(), 0.1F);
  const BoxUncertainty noisy = UncertaintyOf(SeenFrom(0.8F, 0.02F, true), KnownBox(), 0.1F);
  EXPECT_GT(noisy.size_sigma_m.z(), clear.size_sigma_m.z());
  EXPECT_GT(noisy.pose_covariance(3, 3), clear.pose_covariance(3, 3));
}

TEST(Uncertainty, IsFiniteHoweverThinTheSolidIs) {
  for (const float thickness_m : {0.0F, 1e-6F, 1e-4F, 1e-3F}) {
    for (const float noise_m : {0.0002F, 0.001F, 0.002F, 0.004F}) {
      Solid sheet = KnownBox();  // in the plane of what is seen
      sheet.center.y() = -0.06F;
      sheet.half_width_m = thickness_m / 2;
      const BoxUncertainty thin = UncertaintyOf(SeenFrom(0.08F, noise_m, false), sheet, 0.1F);
      EXPECT_TRUE(thin.pose_covariance.allFinite()) << thickness_m << " " << noise_m;
      EXPECT_TRUE(thin.size_sigma_m.allFinite()) << thickness_m << " " << noise_m;
      EXPECT_GT(thin.size_sigma_m.minCoeff(), 0);
      EXPECT_GE(thin.pose_covariance.diagonal().minCoeff(), 0);
    }
  }
}

TEST(Uncertainty, IsACovarianceInTheCamerasFrame) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.2, 0.12, 0.15}, {-0.15, 0}, 0, 0.5),
                      Thing(ShapeKind::kSphere, {0.1, 0.1, 0.1}, {0.2, 0}, 0)},
                     35)
          .detections;
  for (const DetectedObject& object : found.objects) {
    ASSERT_TRUE(object.uncertainty);
    const Eigen::Matrix4f& covariance = object.uncertainty->pose_covariance;
    EXPECT_EQ(covariance, covariance.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4f> solver(covariance);
    EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-9F);
    EXPECT_GT(object.uncertainty->size_sigma_m.minCoeff(), 0);
  }
  // Any turn describes a ball as well as any other.
  EXPECT_EQ(found.objects[1].uncertainty->pose_covariance(3, 3), 0);
  EXPECT_GT(found.objects[0].uncertainty->pose_covariance(3, 3), 0);
}

}  // namespace
}  // namespace fovea
