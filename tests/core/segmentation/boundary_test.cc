#include "core/segmentation/boundary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea {
namespace {

const SegmentPair kPair{1, 2};

// Voxels of a centimetre that face the camera, in cells that the tests say.
struct Cells {
  void Add(int label, const Eigen::Vector3i& cell) {
    grid.voxels.push_back(
        {.cell = cell, .mean = cell.cast<float>() / 100, .normal = -Eigen::Vector3f::UnitZ()});
    labels.push_back(label);
    colors.push_back({.sum = Eigen::Vector3d(3.0 * label, 0, 0), .num_pixels = 1});
    for (int v = 0; v + 1 < static_cast<int>(labels.size()); ++v) {
      const Eigen::Vector3i step = grid.voxels[v].cell - cell;
      if (step.cwiseAbs().maxCoeff() <= 1) {
        grid.edges.push_back({v, static_cast<int>(labels.size()) - 1});
      }
    }
  }
  // A sheet of width × height voxels whose corner lies in `cell`.
  void AddSheet(int label, const Eigen::Vector3i& cell, int width, int height) {
    for (int x = 0; x < width; ++x) {
      for (int y = 0; y < height; ++y) Add(label, cell + Eigen::Vector3i(x, y, 0));
    }
  }
  Boundaries Of() const { return CollectBoundaries(grid, labels, colors, {0, -1, 0}); }

  VoxelGrid grid;
  std::vector<int> labels;
  std::vector<MeanColor> colors;
};

// One pair steps 45° towards the camera, the other as much upwards and away from it.
TEST(CollectBoundaries, SumsUpWhatTellsThePairsApart) {
  Cells cells;
  cells.Add(1, {0, 0, 100});
  cells.Add(2, {1, 0, 99});
  cells.Add(1, {10, 0, 100});
  cells.Add(2, {10, -1, 101});
  cells.Add(0, {10, 1, 101});
  const Boundaries boundaries = cells.Of();
  ASSERT_EQ(boundaries.size(), 1U);
  const Boundary& boundary = boundaries.at(kPair);
  EXPECT_EQ(boundary.num_pairs, 2);
  EXPECT_NEAR(boundary.step_sum_deg, 90, 1e-3);
  EXPECT_NEAR(boundary.contrast_sum, 2 * 3, 1e-9);
  EXPECT_NEAR(boundary.way_sum_m2, 2 * 2e-4, 1e-9);
  EXPECT_NEAR(boundary.rise_sum_m2, 1e-4, 1e-9);
}

TEST(CollectBoundaries, LeavesOutVoxelsWithoutANormal) {
  Cells cells;
  cells.AddSheet(1, {0, 0, 100}, 1, 2);
  cells.Add(2, {1, 0, 100});
  cells.grid.voxels[1].normal.setZero();
  EXPECT_EQ(cells.Of().at(kPair).num_pairs, 1);
}

TEST(CollectBoundaries, GoesAcrossAGapOfOneVoxelBetweenRims) {
  Cells cells;
  cells.AddSheet(1, {0, 0, 100}, 4, 5);
  cells.AddSheet(2, {5, 0, 100}, 4, 5);
  EXPECT_EQ(cells.Of().at(kPair).num_pairs, 5 + 2 * 4 + 2 * 3) << "rows 0, 1 and 2 apart";
  Cells wider;
  wider.AddSheet(1, {0, 0, 100}, 4, 5);
  wider.AddSheet(2, {6, 0, 100}, 4, 5);
  EXPECT_TRUE(wider.Of().empty());
}

TEST(CollectBoundaries, AGapNeedsFourPairs) {
  Cells three, four;
  three.AddSheet(1, {0, 0, 100}, 1, 1);
  three.AddSheet(2, {2, 0, 100}, 1, 3);
  EXPECT_TRUE(three.Of().empty());
  four.AddSheet(1, {0, 0, 100}, 1, 2);
  four.AddSheet(2, {2, 0, 100}, 1, 2);
  EXPECT_EQ(four.Of().at(kPair).num_pairs, 4);
}

// A small thing closely before a larger one.
TEST(CollectBoundaries, ThereIsNoGapToTheMidstOfASegment) {
  Cells cells;
  cells.AddSheet(1, {0, 0, 100}, 9, 9);
  cells.AddSheet(2, {4, 4, 98}, 2, 2);
  EXPECT_TRUE(cells.Of().empty());
}

// Pairs that touch are not counted with those a voxel apart.
TEST(CollectBoundaries, WhatTouchesHasNoGap) {
  Cells cells;
  cells.AddSheet(1, {0, 0, 100}, 1, 5);
  cells.AddSheet(2, {1, 0, 100}, 1, 5);
  EXPECT_EQ(cells.Of().at(kPair).num_pairs, 5 + 2 * 4);
}

}  // namespace
}  // namespace fovea
