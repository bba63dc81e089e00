#include "core/segmentation/roundness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace fovea {
namespace {

const Eigen::Vector3f kGridUp = -Eigen::Vector3f::UnitY();
const Eigen::Vector3f kAxis(0.1F, 0, 1);
constexpr float kRadius = 0.05F;

// Voxels of an upright cylinder over `arc_rad`, centred on the far side as a camera at the origin
// sees its inside, or on the near side as it sees its outside. `tilt` leans the normals upwards, as
// those of bowls: their horizontal part is the cosine.
VoxelGrid Cylinder(bool inside, float arc_rad, float tilt_rad = 0) {
  VoxelGrid grid;
  for (int i = 0; i <= 40; ++i) {
    const float angle = arc_rad * (static_cast<float>(i) / 40 - 0.5F);
    const Eigen::Vector3f way(std::sin(angle), 0, (inside ? 1.0F : -1.0F) * std::cos(angle));
    const Eigen::Vector3f normal =
        std::cos(tilt_rad) * (inside ? -1.0F : 1.0F) * way + std::sin(tilt_rad) * kGridUp;
    for (int row = 0; row < 5; ++row) {
      grid.voxels.push_back(
          {.mean = kAxis + kRadius * way + 0.01F * static_cast<float>(row) * kGridUp,
           .normal = normal});
    }
  }
  return grid;
}

std::vector<int> AllOf(const VoxelGrid& grid) {
  std::vector<int> voxels(grid.voxels.size());
  std::iota(voxels.begin(), voxels.end(), 0);
  return voxels;
}

TEST(FitRoundness, FindsTheCylinderFromInsideAndOutside) {
  for (const bool inside : {true, false}) {
    const VoxelGrid grid = Cylinder(inside, 2);
    const Roundness roundness = FitRoundness(grid, AllOf(grid), kGridUp);
    EXPECT_NEAR(roundness.curvature_per_m, (inside ? -1 : 1) / kRadius, 1e-3);
    EXPECT_NEAR(roundness.radius_m, kRadius, 1e-5);
    EXPECT_NEAR((roundness.axis - kAxis).norm(), 0, 1e-5);
  }
}

TEST(FitRoundness, InclinedWallsKeepTheirRadius) {
  const VoxelGrid bowl = Cylinder(true, 2, std::numbers::pi_v<float> / 3);
  const Roundness roundness = FitRoundness(bowl, AllOf(bowl), kGridUp);
  EXPECT_NEAR(roundness.curvature_per_m, -0.5 / kRadius, 1e-3);
  EXPECT_NEAR(roundness.radius_m, kRadius, 1e-5);
  EXPECT_NEAR((roundness.axis - kAxis).norm(), 0, 1e-5);
}

TEST(FitRoundness, APlaneAndNothingAreNotRound) {
  VoxelGrid plane = Cylinder(true, 2);
  for (Voxel& voxel : plane.voxels) voxel.normal = -Eigen::Vector3f::UnitZ();
  for (const auto& voxels : {AllOf(plane), std::vector<int>{}}) {
    const Roundness roundness = FitRoundness(plane, voxels, kGridUp);
    EXPECT_EQ(roundness.curvature_per_m, 0);
    EXPECT_EQ(roundness.radius_m, 0);
  }
}

TEST(MeanFacing, TellsInsideFromOutside) {
  const VoxelGrid inside = Cylinder(true, 2), outside = Cylinder(false, 2);
  EXPECT_NEAR(MeanFacing(inside, AllOf(inside), kAxis, kGridUp), -1, 1e-5);
  EXPECT_NEAR(MeanFacing(outside, AllOf(outside), kAxis, kGridUp), 1, 1e-5);
  // The same outside stands elsewhere: behind the axis it faces it.
  EXPECT_LT(
      MeanFacing(outside, AllOf(outside), kAxis - 2 * kRadius * Eigen::Vector3f::UnitZ(), kGridUp),
      -0.5);
}

TEST(MeanFacing, IsZeroWhereNothingFacesSideways) {
  const VoxelGrid level = Cylinder(true, 2, std::numbers::pi_v<float> / 2);
  EXPECT_EQ(MeanFacing(level, AllOf(level), kAxis, kGridUp), 0);
}

}  // namespace
}  // namespace fovea
