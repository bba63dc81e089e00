#include "core/seeds/covering_seeds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/segmentation/adjacency.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr std::size_t kMinVoxels = 20;  // of a connected part; fewer are noise
// Along an axis of the camera: what is longer is wall or furniture, on which only what is salient
// is looked for.
constexpr float kMaxExtentM = 1.5F;
constexpr float kUnreached = std::numeric_limits<float>::infinity();

struct Step {
  int voxel = 0;
  float length_m = 0;
};

using Neighbors = Adjacency<Step>;

Neighbors NeighborsOf(const VoxelGrid& grid, const std::vector<char>& is_background) {
  const std::vector<Voxel>& voxels = grid.voxels;
  return {voxels.size(), EdgesWithin(grid, is_background, 0),
          [&](const VoxelEdge& edge, int voxel) {
            return Step{voxel, (voxels[edge.a].mean - voxels[edge.b].mean).norm()};
          }};
}

// Distance of every voxel to the nearest source along the surface, kept up to date as sources are
// added.
class SurfaceDistance {
 public:
  SurfaceDistance(const VoxelGrid& grid, const std::vector<char>& is_background)
      : neighbors_(NeighborsOf(grid, is_background)),
        distance_(grid.voxels.size(), kUnreached),
        is_queued_(grid.voxels.size()) {
    queue_.reserve(grid.voxels.size());
  }

  float Of(int voxel) const { return distance_[voxel]; }

  // In order of steps instead of distance: the distances are the same, and no heap is kept.
  void AddSource(int source) {
    LongLoop loop;
    queue_.clear();
    Reach(source, 0);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      loop.Turn();
      const int voxel = queue_[next];
      is_queued_[voxel] = 0;
      for (const Step& step : neighbors_.Of(voxel)) {
        Reach(step.voxel, distance_[voxel] + step.length_m);
      }
    }
  }

 private:
  void Reach(int voxel, float distance) {
    if (distance >= distance_[voxel]) return;
    distance_[voxel] = distance;
    if (std::exchange(is_queued_[voxel], 1) == 0) queue_.push_back(voxel);
  }

  Neighbors neighbors_;
  std::vector<float> distance_;
  std::vector<char> is_queued_;  // none between calls
  std::vector<int> queue_;       // kept for its memory
};

// The voxels of a connected part of what is not background.
using VoxelsOfPart = std::span<const int>;

int MostCentral(const VoxelGrid& grid, VoxelsOfPart part) {
  InterruptionPoint();
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const int v : part) mean += grid.voxels[v].mean / static_cast<float>(part.size());
  return *std::min_element(part.begin(), part.end(), [&](int a, int b) {
    return (grid.voxels[a].mean - mean).squaredNorm() < (grid.voxels[b].mean - mean).squaredNorm();
  });
}

// Longest side of the part's box along the camera's axes.
float Extent(const VoxelGrid& grid, VoxelsOfPart part) {
  Eigen::AlignedBox3f box;
  for (const int v : part) box.extend(grid.voxels[v].mean);
  return box.sizes().maxCoeff();
}

int Farthest(VoxelsOfPart part, const SurfaceDistance& distance) {
  InterruptionPoint();
  return *std::max_element(part.begin(), part.end(),
                           [&](int a, int b) { return distance.Of(a) < distance.Of(b); });
}

std::vector<int> VoxelsToAdd(const VoxelGrid& grid, const std::vector<char>& is_background,
                             SurfaceDistance& distance, const CoverOptions& options) {
  constexpr std::size_t kUsualSeeds = 64;
  std::vector<int> added;
  added.reserve(kUsualSeeds);
  const auto add = [&](int voxel) {
    added.push_back(voxel);
    distance.AddSource(voxel);
  };
  const Lists<int> parts = IndicesOfLabels(PartsOfForeground(grid, is_background));
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const VoxelsOfPart part = parts[i];
    if (part.size() < kMinVoxels || Extent(grid, part) > kMaxExtentM) continue;
    if (distance.Of(part.front()) == kUnreached) add(MostCentral(grid, part));
    for (int voxel = Farthest(part, distance);
         distance.Of(voxel) > static_cast<float>(options.spacing_m);
         voxel = Farthest(part, distance)) {
      add(voxel);
    }
  }
  return added;
}

}  // namespace

std::vector<Seed> CoverWithSeeds(const VoxelGrid& grid, const std::vector<char>& is_background,
                                 const std::vector<Seed>& seeds, const CoverOptions& options) {
  if (options.spacing_m <= 0) return seeds;
  SurfaceDistance distance(grid, is_background);
  InterruptionPoint();
  for (const Seed& seed : seeds) {
    const int voxel = grid.voxel_of_pixel.at<int>(seed.pixel);
    if (voxel >= 0 && !is_background[voxel]) distance.AddSource(voxel);
  }
  const std::vector<int> added = VoxelsToAdd(grid, is_background, distance, options);
  std::vector<Seed> covering = seeds;
  covering.reserve(seeds.size() + added.size());
  for (const int voxel : added) {
    covering.push_back(
        {grid.voxels[voxel].first_px, grid.voxels[voxel].mean, Seed::Source::kUnexplainedRegion});
  }
  return covering;
}

}  // namespace fovea
