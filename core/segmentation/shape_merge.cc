#include "core/segmentation/shape_merge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/flatness.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/segment_color.h"

namespace fovea {
namespace {

struct Boundary {
  double convexity_sum_deg = 0;
  int num_pairs = 0;

  void Add(const Boundary& other) {
    convexity_sum_deg += other.convexity_sum_deg;
    num_pairs += other.num_pairs;
  }
};

using SegmentPair = std::pair<int, int>;  // first < second
using Boundaries = std::map<SegmentPair, Boundary>;

Boundaries CollectBoundaries(const VoxelGrid& grid, const std::vector<int>& labels, int reach) {
  Boundaries boundaries;
  for (const VoxelEdge& pair : PairsWithin(grid, labels, reach)) {
    const auto [low, high] = std::minmax(labels[pair.a], labels[pair.b]);
    if (low == 0 || low == high) continue;
    const Voxel& a = grid.voxels[pair.a];
    const Voxel& b = grid.voxels[pair.b];
    if (a.normal.isZero() || b.normal.isZero()) continue;
    boundaries[{low, high}].Add({ConvexityDeg(a, b), 1});
  }
  return boundaries;
}

// What a merge looks at besides the boundary.
struct Segment {
  SegmentColor color;
  Spread spread;

  void Add(const Segment& other) {
    color.Add(other.color);
    spread.Add(other.spread);
  }
};

std::vector<Segment> CollectSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                     const cv::Mat& color_rgb) {
  const std::vector<SegmentColor> colors = ColorsOfSegments(grid, labels, color_rgb);
  const std::vector<Spread> spreads = SpreadOfSegments(grid, labels);
  std::vector<Segment> segments;
  for (std::size_t label = 0; label < colors.size(); ++label) {
    segments.push_back({colors[label], spreads[label]});
  }
  return segments;
}

bool MerelyTouch(const Boundary& boundary, const Segment& a, const Segment& b,
                 const ShapeMergeOptions& options) {
  const double width = std::sqrt(std::min(a.spread.num_voxels, b.spread.num_voxels));
  return boundary.num_pairs < std::max<double>(options.min_pairs, options.min_contact * width);
}

// How much speaks for the two being one object; they are if it is above 0.
double Affinity(const Boundary& boundary, const Segment& a, const Segment& b,
                const ShapeMergeOptions& options) {
  if (MerelyTouch(boundary, a, b, options)) return 0;
  double convexity_deg = boundary.convexity_sum_deg / boundary.num_pairs;
  if (convexity_deg < 0 && options.plane_noise_per_m > 0 &&
      AreOnOnePlane(a.spread, b.spread, options.plane_noise_per_m)) {
    convexity_deg = 0;
  }
  return convexity_deg + options.max_concavity_deg -
         options.color_weight_deg * a.color.DistanceTo(b.color);
}

// Moves the boundaries of segment `from` to segment `into`.
void JoinBoundaries(Boundaries& boundaries, int into, int from) {
  boundaries.erase({std::min(into, from), std::max(into, from)});
  Boundaries moved;
  for (auto it = boundaries.begin(); it != boundaries.end();) {
    const auto [low, high] = it->first;
    if (low != from && high != from) {
      ++it;
      continue;
    }
    const int other = low == from ? high : low;
    moved[{std::min(into, other), std::max(into, other)}].Add(it->second);
    it = boundaries.erase(it);
  }
  for (const auto& [pair, boundary] : moved) boundaries[pair].Add(boundary);
}

}  // namespace

std::vector<int> MergeByShape(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ShapeMergeOptions& options) {
  if (options.max_concavity_deg <= 0) return labels;
  Boundaries boundaries = CollectBoundaries(grid, labels, options.reach_cells);
  std::vector<Segment> segments = CollectSegments(grid, labels, color_rgb);
  DisjointSets objects(static_cast<int>(segments.size()));
  while (true) {
    double best = 0;
    SegmentPair pair{0, 0};
    for (const auto& [candidate, boundary] : boundaries) {
      const double affinity =
          Affinity(boundary, segments[candidate.first], segments[candidate.second], options);
      if (affinity > best) {
        best = affinity;
        pair = candidate;
      }
    }
    if (best <= 0) break;
    objects.Join(pair.first, pair.second);  // the smaller number stays
    segments[pair.first].Add(segments[pair.second]);
    JoinBoundaries(boundaries, pair.first, pair.second);
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
