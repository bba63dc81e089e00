#include "core/scene/flat_things.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/scene/standing_out.h"
#include "core/segmentation/disjoint_sets.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kReach = 3;             // voxels around objects that may be their edge
constexpr int kMinNeighbors = 3;      // of four on a surface, in the midst of a thing
constexpr int kMinVoxels = 12;        // of a thing
constexpr float kMaxExtent_m = 0.5F;  // diagonal of its bounding box along the camera's axes
constexpr float kMinRise = 0.15F;     // over what is around it, as a share of the tolerance
constexpr int kGap = 2, kRing = 4;    // voxels between a thing and what is around it, and of that

using Voxels = std::vector<char>;  // one entry a voxel, 1 = in the set

// Adds the neighbours along these edges.
void Grow(const std::vector<VoxelEdge>& edges, Voxels& set) {
  const Voxels before = set;
  InterruptionPoint();
  for (const VoxelEdge& edge : edges) {
    set[edge.a] |= before[edge.b];
    set[edge.b] |= before[edge.a];
  }
}

// Of what stands out, what is neither the edge of an object nor thinner than a few voxels.
Voxels WithoutEdges(const VoxelGrid& grid, const Voxels& is_background, const Voxels& stands_out) {
  const std::size_t count = grid.voxels.size();
  Voxels near_objects(count);
  std::transform(is_background.begin(), is_background.end(), near_objects.begin(),
                 [](char background) { return background == 0 ? 1 : 0; });
  for (int i = 0; i < kReach; ++i) Grow(grid.edges, near_objects);
  const std::vector<VoxelEdge> edges = EdgesWithin(grid, stands_out, 1);
  std::vector<int> num_neighbors(count, 0);  // that stand out too
  for (const VoxelEdge& edge : edges) {
    ++num_neighbors[edge.a];
    ++num_neighbors[edge.b];
  }
  Voxels things(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    const bool is_midst = stands_out[v] != 0 && num_neighbors[v] >= kMinNeighbors;
    things[v] = is_midst && near_objects[v] == 0 ? 1 : 0;
  }
  for (int i = 0; i <= kReach; ++i) Grow(edges, things);
  return things;
}

struct Mean {
  double sum = 0, count = 0;

  void Add(double value) {
    sum += value;
    ++count;
  }
  double Value() const { return count > 0 ? sum / count : 0; }
};

struct Thing {
  Eigen::AlignedBox3f extent;
  int num_voxels = 0;
  Mean height_m, distance_m;
  Mean height_around_m;

  // Whatever is around it.
  bool MayBeOne() const {
    return num_voxels >= kMinVoxels && extent.diagonal().norm() <= kMaxExtent_m;
  }
  bool IsOne(const SupportOptions& tolerance) const {
    if (!MayBeOne()) return false;
    if (height_around_m.count == 0) return true;
    const auto distance = static_cast<float>(distance_m.Value());
    return height_m.Value() - height_around_m.Value() >=
           kMinRise * SupportTolerance(distance, tolerance);
  }
};

// Of each voxel the first one of its connected part, -1 for those in none.
std::vector<int> PartsOf(const VoxelGrid& grid, const Voxels& things) {
  DisjointSets sets(static_cast<int>(things.size()));
  InterruptionPoint();
  for (const VoxelEdge& edge : grid.edges) {
    if (things[edge.a] != 0 && things[edge.b] != 0) sets.Join(edge.a, edge.b);
  }
  std::vector<int> parts(things.size(), -1);
  for (int v = 0; v < static_cast<int>(things.size()); ++v) {
    if (things[v] != 0) parts[v] = sets.Find(v);
  }
  return parts;
}

// The height of the support around each thing.
void MeasureAround(const VoxelGrid& grid, std::vector<int> parts, const OnSupports& on,
                   std::map<int, Thing>& things) {
  for (int step = 0; step < kGap + kRing; ++step) {
    const std::vector<int> before = parts;
    InterruptionPoint();
    const auto spread = [&](int from, int to) {
      if (before[from] < 0 || parts[to] >= 0 || std::isnan(on.height_m[to])) return;
      parts[to] = before[from];
      if (step < kGap || on.stands_out[to] != 0) return;
      things[before[from]].height_around_m.Add(on.height_m[to]);
    };
    for (const VoxelEdge& edge : grid.edges) {
      spread(edge.a, edge.b);
      spread(edge.b, edge.a);
    }
  }
}

std::map<int, Thing> Measure(const VoxelGrid& grid, const std::vector<int>& parts,
                             const OnSupports& on) {
  std::map<int, Thing> things;
  LongLoop loop;
  for (std::size_t v = 0; v < parts.size(); ++v) {
    loop.Turn();
    if (parts[v] < 0) continue;
    Thing& thing = things[parts[v]];
    thing.extent.extend(grid.voxels[v].mean);
    ++thing.num_voxels;
    thing.height_m.Add(on.height_m[v]);
    thing.distance_m.Add(grid.voxels[v].mean.z());
  }
  const bool any = std::any_of(things.begin(), things.end(),
                               [](const auto& thing) { return thing.second.MayBeOne(); });
  if (any) MeasureAround(grid, parts, on, things);
  return things;
}

}  // namespace

std::vector<char> FindFlatThings(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                                 const std::vector<char>& is_background,
                                 const std::vector<Support>& supports,
                                 const SupportOptions& tolerance, const FlatThingOptions& options) {
  Voxels things(grid.voxels.size(), 0);
  if (options.min_contrast <= 0 || supports.empty()) return things;
  const OnSupports on =
      FindStandingOut(grid, colors, is_background, supports, tolerance, options.min_contrast);
  if (std::find(on.stands_out.begin(), on.stands_out.end(), 1) == on.stands_out.end())
    return things;
  const std::vector<int> parts = PartsOf(grid, WithoutEdges(grid, is_background, on.stands_out));
  const std::map<int, Thing> measured = Measure(grid, parts, on);
  for (std::size_t v = 0; v < parts.size(); ++v) {
    things[v] = parts[v] >= 0 && measured.at(parts[v]).IsOne(tolerance) ? 1 : 0;
  }
  return things;
}

}  // namespace fovea
