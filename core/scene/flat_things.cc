#include "core/scene/flat_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/segmentation/disjoint_sets.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kBin = 6;            // of colours, in their units
constexpr double kUsualShare = 0.03;  // of the area of a support
constexpr int kReach = 3;             // voxels around objects that may be their edge
constexpr int kMinNeighbors = 3;      // of four on a surface, in the midst of a thing
constexpr int kMinVoxels = 12;        // of a thing
constexpr float kMaxExtent_m = 0.5F;  // of its bounding box along the camera's axes, diagonal

using Voxels = std::vector<char>;  // one entry a voxel, 1 = in the set

std::vector<int> VoxelsOn(const Support& support, const VoxelGrid& grid,
                          const Voxels& is_background, const SupportOptions& tolerance) {
  std::vector<int> on;
  LongLoop loop;
  for (int v = 0; v < static_cast<int>(grid.voxels.size()); ++v) {
    loop.Turn();
    const Eigen::Vector3f& p = grid.voxels[v].mean;
    const float most = support.LargestShare() * SupportTolerance(p.z(), tolerance);
    if (!is_background[v] || std::abs(support.surface.HeightOf(p)) > most) continue;
    if (support.footprint.Covers(p)) on.push_back(v);
  }
  return on;
}

// The colours that much of what is seen of a support has, by area.
std::vector<Eigen::Vector3d> UsualColors(const VoxelGrid& grid, const std::vector<int>& on,
                                         const std::vector<MeanColor>& colors) {
  struct Sum {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double area = 0;
  };
  std::map<std::array<int, 3>, Sum> bins;
  double total = 0;
  LongLoop loop;
  for (const int v : on) {
    loop.Turn();
    const Eigen::Vector3d color = colors[v].Mean();
    const Eigen::Vector3i bin = (color / kBin).array().floor().cast<int>();
    const double z = grid.voxels[v].mean.z();
    const double area = grid.voxels[v].num_points * z * z;
    Sum& sum = bins[{bin.x(), bin.y(), bin.z()}];
    sum.color += area * color;
    sum.area += area;
    total += area;
  }
  std::vector<Eigen::Vector3d> usual;
  for (const auto& [bin, sum] : bins) {
    if (sum.area >= kUsualShare * total) usual.push_back(sum.color / sum.area);
  }
  return usual;
}

Voxels StandingOut(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                   const Voxels& is_background, const std::vector<Support>& supports,
                   const SupportOptions& tolerance, double min_contrast) {
  Voxels stands_out(grid.voxels.size(), 0);
  for (const Support& support : supports) {
    const std::vector<int> on = VoxelsOn(support, grid, is_background, tolerance);
    const std::vector<Eigen::Vector3d> usual = UsualColors(grid, on, colors);
    if (usual.empty()) continue;  // where nothing is, nothing stands out
    LongLoop loop;
    for (const int v : on) {
      loop.Turn();
      const Eigen::Vector3d color = colors[v].Mean();
      stands_out[v] = std::all_of(usual.begin(), usual.end(), [&](const Eigen::Vector3d& other) {
        return (color - other).norm() > min_contrast;
      });
    }
  }
  return stands_out;
}

// Adds the neighbours, those in `within` if it is given.
void Grow(const VoxelGrid& grid, const Voxels* within, Voxels& set) {
  const Voxels before = set;
  InterruptionPoint();
  for (const VoxelEdge& edge : grid.edges) {
    if (before[edge.a] && (within == nullptr || (*within)[edge.b])) set[edge.b] = 1;
    if (before[edge.b] && (within == nullptr || (*within)[edge.a])) set[edge.a] = 1;
  }
}

// Of `stands_out` what is no edge of an object and no speck.
Voxels WithoutEdges(const VoxelGrid& grid, const Voxels& is_background, const Voxels& stands_out) {
  const std::size_t count = grid.voxels.size();
  Voxels near_objects(count);
  std::transform(is_background.begin(), is_background.end(), near_objects.begin(),
                 [](char background) { return background == 0 ? 1 : 0; });
  for (int i = 0; i < kReach; ++i) Grow(grid, nullptr, near_objects);
  std::vector<int> num_neighbors(count, 0);
  for (const VoxelEdge& edge : grid.edges) {
    num_neighbors[edge.a] += stands_out[edge.b];
    num_neighbors[edge.b] += stands_out[edge.a];
  }
  Voxels things(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    things[v] = stands_out[v] && !near_objects[v] && num_neighbors[v] >= kMinNeighbors ? 1 : 0;
  }
  for (int i = 0; i <= kReach; ++i) Grow(grid, &stands_out, things);
  return things;
}

// Leaves connected parts of the size of things.
void RemoveSpecksAndSheets(const VoxelGrid& grid, Voxels& things) {
  struct Part {
    Eigen::AlignedBox3f extent;
    int num_voxels = 0;
  };
  DisjointSets sets(static_cast<int>(things.size()));
  InterruptionPoint();
  for (const VoxelEdge& edge : grid.edges) {
    if (things[edge.a] && things[edge.b]) sets.Join(edge.a, edge.b);
  }
  std::map<int, Part> parts;
  for (int v = 0; v < static_cast<int>(things.size()); ++v) {
    if (!things[v]) continue;
    Part& part = parts[sets.Find(v)];
    part.extent.extend(grid.voxels[v].mean);
    ++part.num_voxels;
  }
  for (int v = 0; v < static_cast<int>(things.size()); ++v) {
    if (!things[v]) continue;
    const Part& part = parts[sets.Find(v)];
    if (part.num_voxels < kMinVoxels || part.extent.diagonal().norm() > kMaxExtent_m) things[v] = 0;
  }
}

}  // namespace

std::vector<char> FindFlatThings(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                                 const std::vector<char>& is_background,
                                 const std::vector<Support>& supports,
                                 const SupportOptions& tolerance, const FlatThingOptions& options) {
  if (options.min_contrast <= 0 || supports.empty()) return Voxels(grid.voxels.size(), 0);
  Voxels things = WithoutEdges(
      grid, is_background,
      StandingOut(grid, colors, is_background, supports, tolerance, options.min_contrast));
  RemoveSpecksAndSheets(grid, things);
  return things;
}

}  // namespace fovea
