#include "core/paper/surface_energy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea::paper {
namespace {

Voxel At(float x, const Eigen::Vector3f& normal) {
  return {.mean = {x, 0, 1}, .normal = normal.normalized(), .num_points = 1};
}

TEST(SurfaceWeight, IsEquation7) {
  const SurfaceEnergyOptions options{.lambda = 4, .epsilon = 0.1, .normal_constant = 0.1};
  const Eigen::Vector3f left(-1, 0, -1);
  const Eigen::Vector3f right(1, 0, -1);
  const double distance = std::sqrt(2.0) + 0.1;  // of the two unit normals, plus the constant
  // Normals that part are an edge seen from outside: convex, expensive to cut.
  EXPECT_NEAR(SurfaceWeight(At(0, left), At(0.01F, right), options), 4 / distance * 1.1, 1e-5);
  // Normals that meet are a groove: concave, cheap.
  EXPECT_NEAR(SurfaceWeight(At(0, right), At(0.01F, left), options), 4 / distance * 0.1, 1e-5);
  // Equal normals: the sign of Eq. 8 is not above 0.
  EXPECT_NEAR(SurfaceWeight(At(0, left), At(0.01F, left), options), 4 / 0.1 * 0.1, 1e-5);
}

TEST(SurfaceWeight, DoesNotDependOnTheOrder) {
  const Voxel a = At(0, {-0.2F, 0.1F, -1});
  const Voxel b = At(0.01F, {0.3F, 0.2F, -1});
  EXPECT_EQ(SurfaceWeight(a, b, {}), SurfaceWeight(b, a, {}));
}

TEST(BuildSurfaceEnergy, JoinsNeighboursUnlessBothCanOnlyBeBackground) {
  VoxelGrid grid;
  for (int v = 0; v < 3; ++v) {
    grid.voxels.push_back(At(0.01F * static_cast<float>(v), {0, 0, -1}));
  }
  grid.edges = {{0, 1}, {1, 2}};
  grid.voxel_of_pixel = (cv::Mat_<int>(1, 3) << 0, 1, 2);
  const cv::Mat points = (cv::Mat_<cv::Vec3f>(1, 3) << cv::Vec3f(0, 0, 1), cv::Vec3f(0.01F, 0, 1),
                          cv::Vec3f(0.02F, 0, 1));
  const PottsEnergy energy = BuildSurfaceEnergy(grid, points, {1, 1, 0}, {}, {}, {});
  ASSERT_EQ(energy.edges.size(), 1U);
  EXPECT_EQ(energy.edges[0].a, 1);
  EXPECT_EQ(energy.edges[0].weight, SurfaceWeight(grid.voxels[1], grid.voxels[2], {}));
  EXPECT_EQ(energy.choices.size(), 1U);
}

}  // namespace
}  // namespace fovea::paper
