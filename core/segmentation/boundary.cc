#include "core/segmentation/boundary.h"

#include <algorithm>
#include <cmath>

namespace fovea {

void Boundary::Add(const Boundary& other) {
  num_pairs += other.num_pairs;
  convexity_sum_deg += other.convexity_sum_deg;
  step_sum_deg += other.step_sum_deg;
  contrast_sum += other.contrast_sum;
}

Boundaries CollectBoundaries(const VoxelGrid& grid, const std::vector<int>& labels,
                             const std::vector<MeanColor>& colors) {
  Boundaries boundaries;
  for (const VoxelEdge& pair : PairsWithin(grid, labels, 1)) {
    const auto [low, high] = std::minmax(labels[pair.a], labels[pair.b]);
    const Voxel& a = grid.voxels[pair.a];
    const Voxel& b = grid.voxels[pair.b];
    if (low == high || a.normal.isZero() || b.normal.isZero()) continue;
    boundaries[{low, high}].Add({1, ConvexityDeg(a, b), std::abs(StepDeg(a, b)),
                                 colors[pair.a].DistanceTo(colors[pair.b])});
  }
  return boundaries;
}

}  // namespace fovea
