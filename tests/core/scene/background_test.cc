#include "core/scene/background.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

constexpr CameraIntrinsics kRegionCamera{500, 500, 320, 240};

// Voxels in a row to the right, a centimetre apart and a metre away: each is beside the next.
VoxelGrid RowOf(int num) {
  VoxelGrid grid;
  for (int i = 0; i < num; ++i) {
    Voxel voxel;
    voxel.mean = {0.01F * static_cast<float>(i), 0, 1};
    grid.voxels.push_back(voxel);
    if (i > 0) grid.edges.push_back({i - 1, i});
  }
  return grid;
}

std::vector<char> HiddenIn(const VoxelGrid& grid, const std::vector<Support>& supports,
                           const RegionOptions& region) {
  return FindHiddenByRegion(grid, supports, {}, kRegionCamera, region);
}

TEST(FindHiddenByRegion, WhereTheRegionAloneKeepsItFromBeingAnObject) {
  const VoxelGrid grid = RowOf(4);
  EXPECT_EQ(HiddenIn(grid, {}, {.max_x_m = 0.015}), (std::vector<char>{0, 0, 1, 1}));
  EXPECT_EQ(HiddenIn(grid, {}, {.x_px = 327}), (std::vector<char>{1, 1, 0, 0}));
  EXPECT_TRUE(HiddenIn(grid, {}, {}).empty());
  // On the table itself nothing is an object, wherever it is.
  const std::vector<Support> table = {{{-Eigen::Vector3f::UnitY(), 0, 100}, Footprint()}};
  EXPECT_EQ(HiddenIn(grid, table, {.max_x_m = 0.015}), (std::vector<char>{0, 0, 0, 0}));
}

TEST(FindCutByRegion, IsWhatHasAHiddenVoxelBesideIt) {
  const VoxelGrid grid = RowOf(7);
  const std::vector<int> objects = {1, 1, 0, 2, 2, 0, 3};
  EXPECT_EQ(FindCutByRegion(grid, objects, 3, {0, 0, 0, 0, 0, 1, 0}), (std::vector<char>{0, 1, 1}));
  EXPECT_EQ(FindCutByRegion(grid, objects, 3, {0, 0, 0, 0, 0, 0, 0}), (std::vector<char>{0, 0, 0}));
  EXPECT_TRUE(FindCutByRegion(grid, objects, 3, {}).empty());
}

}  // namespace
}  // namespace fovea
