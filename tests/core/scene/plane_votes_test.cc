#include "core/scene/plane_votes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea {
namespace {

const Eigen::Vector3f kGridUp = -Eigen::Vector3f::UnitY();

// Two upright planes: the nearer one looks smaller by far, for as many voxels.
VoxelGrid TwoPlanes() {
  VoxelGrid grid;
  for (int i = 0; i < 20; ++i) {
    const float x = 0.02F * static_cast<float>(i);
    grid.voxels.push_back(
        {.mean = {x, 0, 3.01F}, .normal = -Eigen::Vector3f::UnitZ(), .num_points = 4});
    grid.voxels.push_back(
        {.mean = {-1.01F, x, 2}, .normal = Eigen::Vector3f::UnitX(), .num_points = 4});
  }
  return grid;
}

std::vector<int> Every(int step, int first, std::size_t count) {
  std::vector<int> voters;
  for (int i = first; i < static_cast<int>(count); i += step) voters.push_back(i);
  return voters;
}

TEST(PlaneVotes, AreForThePlaneOfMostVisibleArea) {
  const VoxelGrid grid = TwoPlanes();
  const PlaneVotes votes(grid, Every(1, 0, grid.voxels.size()), kGridUp);
  const auto plane = votes.MostVoted();
  ASSERT_TRUE(plane);
  // Directions within 45° share the votes, so that the distance is not that of the plane alone.
  EXPECT_GT(plane->normal.dot(-Eigen::Vector3f::UnitZ()), 0.7F);
  EXPECT_NEAR(plane->normal.dot(kGridUp), 0, 1e-6);
  EXPECT_NEAR(plane->normal.norm(), 1, 1e-6);
}

TEST(PlaneVotes, AreTakenBackWithoutALeftover) {
  const VoxelGrid grid = TwoPlanes();
  PlaneVotes votes(grid, Every(1, 0, grid.voxels.size()), kGridUp);
  votes.Remove(Every(2, 0, grid.voxels.size()));
  const auto plane = votes.MostVoted();
  ASSERT_TRUE(plane);
  EXPECT_GT(plane->normal.dot(Eigen::Vector3f::UnitX()), 0.7F);
  EXPECT_LT(std::abs(plane->HeightOf({-1.01F, 0.2F, 2})), 0.05F);
  votes.Remove(Every(2, 1, grid.voxels.size()));
  EXPECT_FALSE(votes.MostVoted());
}

TEST(PlaneVotes, HoldWhatIsVeryFarAway) {
  VoxelGrid grid;
  grid.voxels.push_back(
      {.mean = {0, 0, 9000}, .normal = -Eigen::Vector3f::UnitZ(), .num_points = 1});
  const PlaneVotes votes(grid, {0}, kGridUp);
  ASSERT_TRUE(votes.MostVoted());
  EXPECT_LT(std::abs(votes.MostVoted()->HeightOf({0, 0, 9000})), 5);
}

}  // namespace
}  // namespace fovea
