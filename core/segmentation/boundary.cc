#include "core/segmentation/boundary.h"

#include <algorithm>
#include <cmath>

#include "core/segmentation/contacts.h"
#include "core/types/interruption.h"

namespace fovea {

void Boundary::Add(const Boundary& other) {
  num_pairs += other.num_pairs;
  convexity_sum_deg += other.convexity_sum_deg;
  step_sum_deg += other.step_sum_deg;
  contrast_sum += other.contrast_sum;
  way_sum_m2 += other.way_sum_m2;
  rise_sum_m2 += other.rise_sum_m2;
}

namespace {

constexpr int kGapCells = 2;
constexpr double kMinGapPairs = 4;

// Of pairs that are not among those that are known.
Boundaries CollectWithin(int reach_cells, const Boundaries& known, const VoxelGrid& grid,
                         const std::vector<int>& labels, const std::vector<MeanColor>& colors,
                         const Eigen::Vector3f& up) {
  Boundaries boundaries;
  LongLoop loop;
  for (const VoxelEdge& pair : FindContacts(grid, labels, reach_cells)) {
    loop.Turn();
    const SegmentPair segments = std::minmax(labels[pair.a], labels[pair.b]);
    if (known.contains(segments)) continue;
    const Voxel& a = grid.voxels[pair.a];
    const Voxel& b = grid.voxels[pair.b];
    if (a.normal.isZero() || b.normal.isZero()) continue;
    const Eigen::Vector3f way_m = b.mean - a.mean;
    const float rise_m = up.dot(way_m);
    boundaries[segments].Add({.num_pairs = 1,
                              .convexity_sum_deg = ConvexityDeg(a, b),
                              .step_sum_deg = std::abs(StepDeg(a, b)),
                              .contrast_sum = colors[pair.a].DistanceTo(colors[pair.b]),
                              .way_sum_m2 = way_m.squaredNorm(),
                              .rise_sum_m2 = rise_m * rise_m});
  }
  return boundaries;
}

// The labels without those of voxels in the midst of a segment, which is a sheet of voxels: they
// have no neighbour of another one.
std::vector<int> LabelsOfRims(const VoxelGrid& grid, std::vector<int> labels) {
  constexpr int kNeighborsInSheet = 4;  // by faces
  std::vector<int> num_alike(labels.size());
  InterruptionPoint();
  for (const VoxelEdge& edge : grid.edges) {
    if (labels[edge.a] == 0 || labels[edge.a] != labels[edge.b]) continue;
    const Eigen::Vector3i step = grid.voxels[edge.a].cell - grid.voxels[edge.b].cell;
    if (step.cwiseAbs().sum() != 1) continue;
    ++num_alike[edge.a];
    ++num_alike[edge.b];
  }
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (num_alike[v] >= kNeighborsInSheet) labels[v] = 0;
  }
  return labels;
}

}  // namespace

Boundaries CollectBoundaries(const VoxelGrid& grid, const std::vector<int>& labels,
                             const std::vector<MeanColor>& colors, const Eigen::Vector3f& up) {
  Boundaries boundaries = CollectWithin(1, {}, grid, labels, colors, up);
  Boundaries gaps =
      CollectWithin(kGapCells, boundaries, grid, LabelsOfRims(grid, labels), colors, up);
  std::erase_if(gaps, [](const auto& gap) { return gap.second.num_pairs < kMinGapPairs; });
  boundaries.merge(gaps);
  return boundaries;
}

}  // namespace fovea
