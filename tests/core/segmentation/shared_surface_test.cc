#include "core/segmentation/shared_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fovea {
namespace {

constexpr SameSurface kSame{.max_angle_deg = 15, .max_offset_m = 0.01};

// Two segments with a gap between them.
struct TwoPatches {
  VoxelGrid grid;
  Lists<int> voxels{2};

  // Level voxels in a row from x = `begin`, 1 cm apart, that climb by `slope` from `height` on.
  void Add(int segment, int count, double begin, double height, double slope = 0) {
    voxels.Begin(segment);
    const Eigen::Vector3d normal = Eigen::Vector3d(slope, -1, 0).normalized();
    for (int i = 0; i < count; ++i) {
      const double way = 0.01 * i;
      voxels.Add(static_cast<int>(grid.voxels.size()));
      grid.voxels.push_back(
          {.mean = Eigen::Vector3d(begin + way, -height + slope * way, 1).cast<float>(),
           .normal = normal.cast<float>()});
    }
  }
  bool AreOne(double min_share) const {
    return SegmentSurfaces(grid, voxels, kSame).AreOne(0, 1, min_share);
  }
};

TEST(SegmentSurfaces, OnePlaneIsOneSurfaceHoweverFarApart) {
  TwoPatches level;
  level.Add(0, 20, 0, 0);
  level.Add(1, 5, 2, 0);
  EXPECT_TRUE(level.AreOne(1));
}

TEST(SegmentSurfaces, AStepIsNone) {
  TwoPatches below, above;
  below.Add(0, 20, 0, 0);
  below.Add(1, 20, 0.5, 0.009);
  EXPECT_TRUE(below.AreOne(1));
  above.Add(0, 20, 0, 0);
  above.Add(1, 20, 0.5, 0.011);
  EXPECT_FALSE(above.AreOne(0.01));
}

TEST(SegmentSurfaces, AnAngleIsNone) {
  for (const double angle_deg : {14.0, 16.0}) {
    const double slope = std::tan(angle_deg * std::numbers::pi / 180);
    TwoPatches bent;
    bent.Add(0, 2, 0, 0);
    bent.Add(1, 2, 0.02, 0.02 * slope / 2, slope);  // 2 cm beside it
    EXPECT_EQ(bent.AreOne(1), angle_deg < 15);
  }
}

// A quarter of the one lies in the plane of the other, all of which lies in that of this quarter.
TEST(SegmentSurfaces, BothHaveToLieOnTheOther) {
  TwoPatches partly;
  partly.Add(0, 5, 0, 0);
  partly.Add(1, 5, 1, 0);
  for (int i = 0; i < 15; ++i) {
    partly.voxels.Add(static_cast<int>(partly.grid.voxels.size()));
    partly.grid.voxels.push_back({.mean = {1, -0.1F, 1}, .normal = {0, -1, 0}});
  }
  EXPECT_TRUE(partly.AreOne(0.25));
  EXPECT_FALSE(partly.AreOne(0.26));
  EXPECT_FALSE(SegmentSurfaces(partly.grid, partly.voxels, kSame).AreOne(1, 0, 0.26));
}

TEST(SegmentSurfaces, NothingIsNoSurface) {
  TwoPatches half;
  half.Add(0, 5, 0, 0);
  half.voxels.Begin(1);
  EXPECT_FALSE(half.AreOne(0.01));
  half.Add(1, 5, 0, 0);
  for (Voxel& voxel : half.grid.voxels) voxel.normal.setZero();
  EXPECT_FALSE(half.AreOne(0.01));
}

// A large segment is compared by voxels from all over it.
TEST(SegmentSurfaces, LargeOnesAreComparedByAFew) {
  TwoPatches large;
  large.Add(0, 1000, 0, 0);
  large.Add(1, 600, 20, 0.02);
  for (int i = 0; i < 400; ++i) {
    large.voxels.Add(static_cast<int>(large.grid.voxels.size()));
    large.grid.voxels.push_back({.mean = {30, 0, 1}, .normal = {0, -1, 0}});
  }
  EXPECT_TRUE(large.AreOne(0.39));
  EXPECT_FALSE(large.AreOne(0.41));
}

}  // namespace
}  // namespace fovea
