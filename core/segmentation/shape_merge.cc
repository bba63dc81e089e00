#include "core/segmentation/shape_merge.h"

#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"

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

struct Appearance {
  Eigen::Vector3d lab_sum = Eigen::Vector3d::Zero();
  double num_pixels = 0;

  void Add(const Appearance& other) {
    lab_sum += other.lab_sum;
    num_pixels += other.num_pixels;
  }
  Eigen::Vector3d Mean() const { return lab_sum / std::max(1.0, num_pixels); }
};

using SegmentPair = std::pair<int, int>;  // first < second
using Boundaries = std::map<SegmentPair, Boundary>;

Boundaries CollectBoundaries(const VoxelGrid& grid, const std::vector<int>& labels, int reach) {
  Boundaries boundaries;
  for (const VoxelEdge& pair : PairsWithin(grid, reach)) {
    const auto [low, high] = std::minmax(labels[pair.a], labels[pair.b]);
    if (low == 0 || low == high) continue;
    const Voxel& a = grid.voxels[pair.a];
    const Voxel& b = grid.voxels[pair.b];
    if (a.normal.isZero() || b.normal.isZero()) continue;
    boundaries[{low, high}].Add({ConvexityDeg(a, b), 1});
  }
  return boundaries;
}

std::vector<Appearance> CollectAppearances(const VoxelGrid& grid, const std::vector<int>& labels,
                                           const cv::Mat& color_rgb) {
  cv::Mat lab;
  cv::cvtColor(color_rgb, lab, cv::COLOR_RGB2Lab);
  std::vector<Appearance> appearances(CountLabels(labels) + 1);
  for (int row = 0; row < lab.rows; ++row) {
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      if (voxel[col] < 0) continue;
      const cv::Vec3b& c = color[col];  // OpenCV scales L to 255; one unit of L is 2.55 there
      appearances[labels[voxel[col]]].Add({{c[0] / 2.55, double(c[1]), double(c[2])}, 1});
    }
  }
  return appearances;
}

// How much speaks for the two being one object; they are if it is above 0.
double Affinity(const Boundary& boundary, const Appearance& a, const Appearance& b,
                const ShapeMergeOptions& options) {
  if (boundary.num_pairs < options.min_pairs) return 0;
  const double convexity_deg = boundary.convexity_sum_deg / boundary.num_pairs;
  const double color_distance = (a.Mean() - b.Mean()).norm();
  return convexity_deg + options.max_concavity_deg - options.color_weight_deg * color_distance;
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
  std::vector<Appearance> appearances = CollectAppearances(grid, labels, color_rgb);
  DisjointSets objects(static_cast<int>(appearances.size()));
  while (true) {
    double best = 0;
    SegmentPair pair{0, 0};
    for (const auto& [candidate, boundary] : boundaries) {
      const double affinity =
          Affinity(boundary, appearances[candidate.first], appearances[candidate.second], options);
      if (affinity > best) {
        best = affinity;
        pair = candidate;
      }
    }
    if (best <= 0) break;
    objects.Join(pair.first, pair.second);  // the smaller number stays
    appearances[pair.first].Add(appearances[pair.second]);
    JoinBoundaries(boundaries, pair.first, pair.second);
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
