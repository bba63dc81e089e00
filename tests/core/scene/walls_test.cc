#include "core/scene/walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace fovea {
namespace {

const Eigen::Vector3f kRoomUp = -Eigen::Vector3f::UnitY();
constexpr SupportOptions kTolerance{.tolerance_m = 0.004, .tolerance_per_m = 0.006};
constexpr WallOptions kWallOptions{.min_extent_m = 0.4};

// Every 2 cm of a length, from its middle.
std::vector<float> Places(float length_m) {
  constexpr float kStep_m = 0.02F;
  std::vector<float> places(static_cast<std::size_t>(std::lround(length_m / kStep_m)) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = kStep_m * static_cast<float>(i) - length_m / 2;
  }
  return places;
}

// A rectangle of voxels every 2 cm around `center`, as wide and high as asked for, with some noise.
void AddUpright(VoxelGrid& grid, const Eigen::Vector3f& center, const Eigen::Vector3f& normal,
                float width_m, float height_m) {
  std::mt19937 random(7);
  const Eigen::Vector3f side = kRoomUp.cross(normal);
  for (const float x : Places(width_m)) {
    for (const float y : Places(height_m)) {
      const float noise_m = static_cast<float>(random() % 1000) / 1000 * 0.008F - 0.004F;
      grid.voxels.push_back({.mean = center + x * side + y * kRoomUp + noise_m * normal,
                             .normal = normal,
                             .num_points = 4});
    }
  }
}

int Count(const std::vector<char>& on_wall, std::size_t first, std::size_t end) {
  return std::accumulate(on_wall.begin() + static_cast<std::ptrdiff_t>(first),
                         on_wall.begin() + static_cast<std::ptrdiff_t>(end), 0);
}

TEST(FindWalls, FindsWallsInAnyDirectionAndLeavesBoxes) {
  VoxelGrid grid;
  AddUpright(grid, {0, 0, 2.5F}, -Eigen::Vector3f::UnitZ(), 2, 1);
  AddUpright(grid, {1, 0, 1.8F}, Eigen::Vector3f(-0.8F, 0, -0.6F), 1, 1);
  const std::size_t walls = grid.voxels.size();
  AddUpright(grid, {0, 0, 1.2F}, -Eigen::Vector3f::UnitZ(), 0.2F, 0.3F);  // a box's front
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions);
  ASSERT_EQ(on_wall.size(), grid.voxels.size());
  EXPECT_GT(Count(on_wall, 0, walls), 0.98 * static_cast<double>(walls));
  EXPECT_EQ(Count(on_wall, walls, grid.voxels.size()), 0);
}

TEST(FindWalls, BoxesInOnePlaneAreNoWall) {
  VoxelGrid grid;
  AddUpright(grid, {-0.3F, 0, 1.2F}, -Eigen::Vector3f::UnitZ(), 0.2F, 0.3F);
  AddUpright(grid, {0.3F, 0, 1.2F}, -Eigen::Vector3f::UnitZ(), 0.2F, 0.3F);
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions);
  EXPECT_EQ(Count(on_wall, 0, on_wall.size()), 0);
}

TEST(FindWalls, ATableIsNoWallWhereItsLegsAndItsEdgeLieInOnePlane) {
  VoxelGrid grid;
  const Eigen::Vector3f towards = -Eigen::Vector3f::UnitZ();
  AddUpright(grid, {0, 0, 1.5F}, towards, 1.2F, 0.04F);  // the edge
  for (const float x : {-0.55F, 0.55F}) AddUpright(grid, {x, 0.35F, 1.5F}, towards, 0.06F, 0.7F);
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions);
  EXPECT_EQ(Count(on_wall, 0, on_wall.size()), 0);
}

// Many boxes in a row, none of them large, get more votes than the wall that the row crosses.
TEST(FindWalls, FindsAllOfAWallThatAnotherPlaneCrosses) {
  VoxelGrid grid;
  AddUpright(grid, {0.5F, 0, 3}, -Eigen::Vector3f::UnitX(), 0.8F, 0.35F);
  const std::size_t wall = grid.voxels.size();
  for (const float x : {-1.5F, -1.1F, -0.7F, -0.3F, 0.1F}) {
    AddUpright(grid, {x, 0, 3}, -Eigen::Vector3f::UnitZ(), 0.3F, 0.35F);
  }
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions);
  EXPECT_EQ(Count(on_wall, 0, wall), static_cast<int>(wall));
}

// Noise tilts the normals of a floor far away until they look upright.
TEST(FindWalls, AStripOfFloorDoesNotMakeAWallOfBoxesInOnePlane) {
  VoxelGrid grid;
  for (const float x : {-0.3F, 0.3F}) {
    AddUpright(grid, {x, 0, 1.2F}, -Eigen::Vector3f::UnitZ(), 0.2F, 0.3F);
  }
  for (const float x : Places(1)) {
    grid.voxels.push_back(
        {.mean = {x, 0.16F, 1.2F}, .normal = -Eigen::Vector3f::UnitZ(), .num_points = 4});
  }
  const std::vector<Support> floor = {{{kRoomUp, 0.16F, 1}, Footprint()}};
  const auto count = [&](const std::vector<Support>& supports) {
    const std::vector<char> on_wall = FindWalls(grid, kRoomUp, supports, kTolerance, kWallOptions);
    return Count(on_wall, 0, on_wall.size());
  };
  EXPECT_GT(count({}), 0);
  EXPECT_EQ(count(floor), 0);
}

TEST(FindWalls, LevelSurfacesAreNoWall) {
  VoxelGrid grid;
  AddUpright(grid, {0, 0, 1.5F}, -Eigen::Vector3f::UnitZ(), 1, 1);
  for (Voxel& voxel : grid.voxels) voxel.normal = kRoomUp;
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions);
  EXPECT_EQ(Count(on_wall, 0, on_wall.size()), 0);
}

TEST(FindWalls, IsOffWithoutAnExtentAndTakesNoVoxels) {
  VoxelGrid grid;
  EXPECT_TRUE(FindWalls(grid, kRoomUp, {}, kTolerance, kWallOptions).empty());
  AddUpright(grid, {0, 0, 2.5F}, -Eigen::Vector3f::UnitZ(), 2, 1);
  const std::vector<char> on_wall = FindWalls(grid, kRoomUp, {}, kTolerance, {.min_extent_m = 0});
  EXPECT_EQ(Count(on_wall, 0, on_wall.size()), 0);
}

}  // namespace
}  // namespace fovea
