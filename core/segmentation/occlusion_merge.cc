#include "core/segmentation/occlusion_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <opencv2/core.hpp>
#include <set>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/gap.h"
#include "core/segmentation/image_borders.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/roundness.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// In an image 640 wide:
constexpr double kBorderReachPx = 4;
constexpr double kMinBorderPx = 10;
constexpr float kBorderStep = 0.01F;
constexpr std::size_t kMaxSamples = 150;  // voxels of a segment that are compared

struct Segment {
  std::vector<int> voxels;
  Roundness roundness;
  float top_m = -std::numeric_limits<float>::max();  // along `up`
};

std::vector<Segment> Collect(const VoxelGrid& grid, const std::vector<int>& labels,
                             const Eigen::Vector3f& up) {
  std::vector<Segment> segments(CountLabels(labels) + 1);
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) {
    if (labels[v] == 0) continue;
    Segment& segment = segments[labels[v]];
    segment.voxels.push_back(v);
    segment.top_m = std::max(segment.top_m, up.dot(grid.voxels[v].mean));
  }
  for (Segment& segment : segments) {
    segment.roundness = FitRoundness(grid, segment.voxels, up);
  }
  return segments;
}

// At most kMaxSamples of the voxels, evenly.
std::vector<int> Sample(const std::vector<int>& voxels) {
  const std::size_t stride = voxels.size() / kMaxSamples + 1;
  std::vector<int> sample;
  for (std::size_t i = 0; i < voxels.size(); i += stride) sample.push_back(voxels[i]);
  return sample;
}

bool OnOneSurface(const Voxel& a, const Voxel& b, const OcclusionMergeOptions& options) {
  if (a.normal.dot(b.normal) < std::cos(options.max_angle_deg * std::numbers::pi / 180)) {
    return false;
  }
  const Eigen::Vector3f step = a.mean - b.mean;
  return std::abs(a.normal.dot(step)) <= options.max_offset_m &&
         std::abs(b.normal.dot(step)) <= options.max_offset_m;
}

// Share of the voxels of `a` that lie on a surface of `b`.
double SharedSurface(const VoxelGrid& grid, const std::vector<int>& a, const std::vector<int>& b,
                     const OcclusionMergeOptions& options) {
  const auto shared = std::count_if(a.begin(), a.end(), [&](int v) {
    return std::any_of(b.begin(), b.end(), [&](int w) {
      return OnOneSurface(grid.voxels[v], grid.voxels[w], options);
    });
  });
  return a.empty() ? 0 : static_cast<double>(shared) / static_cast<double>(a.size());
}

// Finds the pairs to join. Holds what all tests look at.
class Evidence {
 public:
  Evidence(const VoxelGrid& grid, const std::vector<int>& labels, const cv::Mat& points,
           const std::vector<MeanColor>& colors, const Eigen::Vector3f& up,
           const OcclusionMergeOptions& options)
      : grid_(grid),
        options_(options),
        points_(points),
        up_(up),
        segments_(Collect(grid, labels, up)),
        colors_(ColorsOfSegments(labels, colors)),
        image_(LabelImage(grid, labels)),
        min_border_px_(ScaledPx(kMinBorderPx, points.cols, 4)),
        borders_(FindImageBorders(image_, points, ScaledPx(kBorderReachPx, points.cols, 2),
                                  kBorderStep)) {}

  const ImageBorders& Borders() const { return borders_; }

  // Pairs of segments of some size of which a third one hides parts.
  std::set<std::pair<int, int>> PairsWithCommonOccluder() const {
    std::map<int, std::vector<int>> hidden_by;
    for (const auto& [pair, border] : borders_) {
      if (border.first_in_front >= min_border_px_) hidden_by[pair.first].push_back(pair.second);
      if (border.second_in_front >= min_border_px_) hidden_by[pair.second].push_back(pair.first);
    }
    std::set<std::pair<int, int>> pairs;
    for (auto& [front, hidden] : hidden_by) {
      std::erase_if(hidden, [&](int s) { return segments_[s].voxels.size() < kMinVoxels; });
      for (std::size_t i = 0; i < hidden.size(); ++i) {
        for (std::size_t j = i + 1; j < hidden.size(); ++j) {
          pairs.insert(std::minmax(hidden[i], hidden[j]));
        }
      }
    }
    return pairs;
  }
  int NumSegments() const { return static_cast<int>(segments_.size()); }

  // True if `front` hides a part of the border of `back`.
  bool Hides(int front, int back) const {
    const auto border = borders_.find(std::minmax(front, back));
    if (border == borders_.end()) return false;
    const int in_front =
        front < back ? border->second.first_in_front : border->second.second_in_front;
    return in_front >= min_border_px_;
  }

  bool AreOneBehindAnOccluder(int a, int b) const {
    if (colors_[a].DistanceTo(colors_[b]) > options_.max_color_distance) return false;
    const std::vector<int> in_a = Sample(segments_[a].voxels);
    const std::vector<int> in_b = Sample(segments_[b].voxels);
    return SharedSurface(grid_, in_a, in_b, options_) >= options_.min_shared_surface &&
           SharedSurface(grid_, in_b, in_a, options_) >= options_.min_shared_surface &&
           ShareSeenThrough(image_, points_, a, b) <= options_.max_seen_through;
  }

  bool IsInsideOf(int inside, int outside) const {
    if (options_.min_hollow_curvature_per_m <= 0) return false;
    const double curvature = segments_[inside].roundness.curvature_per_m;
    return -curvature >= options_.min_hollow_curvature_per_m && Hides(outside, inside) &&
           std::abs(segments_[inside].top_m - segments_[outside].top_m) <=
               options_.max_rim_step_m &&
           LiesAround(outside, segments_[inside].roundness);
  }

 private:
  static constexpr std::size_t kMinVoxels = 10;
  // How far from the axis the outside lies on average, of the inside's radius, and how much it
  // faces away from the axis.
  static constexpr double kMinShare = 0.25;
  static constexpr double kMaxShare = 1.2;
  static constexpr double kMinFacing = 0.3;

  // True if the segment goes around an axis like the outside of the wall around it: a bowl's is
  // narrower below its rim; something beside the bowl is farther away or faces elsewhere.
  bool LiesAround(int segment, const Roundness& wall) const {
    const std::vector<int>& voxels = segments_[segment].voxels;
    double sum_m = 0;
    for (const int v : voxels) sum_m += (Horizontal(grid_.voxels[v].mean, up_) - wall.axis).norm();
    const double mean_m = sum_m / static_cast<double>(voxels.size());
    return mean_m >= kMinShare * wall.radius_m && mean_m <= kMaxShare * wall.radius_m &&
           MeanFacing(grid_, voxels, wall.axis, up_) >= kMinFacing;
  }

  const VoxelGrid& grid_;
  const OcclusionMergeOptions& options_;
  const cv::Mat& points_;
  const Eigen::Vector3f up_;
  std::vector<Segment> segments_;
  std::vector<MeanColor> colors_;
  cv::Mat image_;
  int min_border_px_;
  ImageBorders borders_;
};

}  // namespace

std::vector<int> MergeOccluded(const VoxelGrid& grid, const std::vector<int>& labels,
                               const cv::Mat& points, const std::vector<MeanColor>& colors,
                               const Eigen::Vector3f& up, const OcclusionMergeOptions& options) {
  if (options.min_shared_surface <= 0 && options.min_hollow_curvature_per_m <= 0) return labels;
  const Evidence evidence(grid, labels, points, colors, up, options);
  DisjointSets objects(evidence.NumSegments());
  for (const auto& [pair, border] : evidence.Borders()) {
    const auto [a, b] = pair;
    if (evidence.IsInsideOf(a, b) || evidence.IsInsideOf(b, a)) objects.Join(a, b);
  }
  if (options.min_shared_surface > 0) {
    for (const auto& [a, b] : evidence.PairsWithCommonOccluder()) {
      if (evidence.AreOneBehindAnOccluder(a, b)) objects.Join(a, b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
