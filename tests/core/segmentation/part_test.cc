#include "core/segmentation/part.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

// A pixel is a centimetre at 1 m, so it is four square centimetres at 2 m.
TEST(CollectParts, SumsUpAreasAndExtents) {
  VoxelGrid grid;
  grid.voxels = {{.mean = {0, 0, 1}, .num_points = 3},
                 {.mean = {0.5F, -0.2F, 2}, .num_points = 5},
                 {.mean = {9, 9, 9}, .num_points = 7}};
  const auto parts =
      CollectParts(grid, {1, 1, 0}, std::vector<MeanColor>(3), {100, 100, 0, 0}, {0, -1, 0});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[1].area_m2, (3 + 4 * 5) * 1e-4, 1e-9);
  EXPECT_EQ(parts[1].num_voxels, 2);
  EXPECT_EQ(parts[1].z_sum_m, 3);
  EXPECT_EQ(parts[1].extent.min(), Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(parts[1].extent.max(), Eigen::Vector3f(0.5F, 2, 0.2F));
}

}  // namespace
}  // namespace fovea
