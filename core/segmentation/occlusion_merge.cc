#include "core/segmentation/occlusion_merge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <set>
#include <span>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/image_borders.h"
#include "core/segmentation/image_hull.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/part.h"
#include "core/segmentation/roundness.h"
#include "core/segmentation/shared_surface.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// In an image 640 wide:
constexpr double kBorderReachPx = 4;
constexpr double kMinBorderPx = 10;
constexpr float kBorderStep = 0.01F;

// Parts behind an occluder: what voxels on one surface have in common,
constexpr SameSurface kSameSurface{.max_angle_deg = 15, .max_offset_m = 0.01};
constexpr double kMaxColorDistance = 60;  // of the mean colours, units of mean_color.h,
// and the share of what lies between them that may show something farther away.
constexpr double kMaxSeenThrough = 0.07;

constexpr double kMaxRimStepM = 0.02;  // between the upper ends of inside and outside

// Each with one entry a label, the background's first and empty.
struct Segments {
  std::vector<Part> parts;
  Lists<int> voxels;
  std::vector<Roundness> roundness;
};

Segments Collect(const VoxelGrid& grid, const std::vector<int>& labels,
                 const std::vector<MeanColor>& colors, const CameraIntrinsics& intrinsics,
                 const Eigen::Vector3f& up) {
  Segments segments;
  segments.parts = CollectParts(grid, labels, colors, intrinsics, up);
  segments.voxels = IndicesOfLabels(labels);
  segments.roundness.resize(segments.parts.size());
  for (std::size_t label = 1; label < segments.parts.size(); ++label) {
    InterruptionPoint();
    segments.roundness[label] = FitRoundness(grid, segments.voxels[label], up);
  }
  return segments;
}

// Finds the pairs to join. Holds what all tests look at.
class Evidence {
 public:
  Evidence(const VoxelGrid& grid, const std::vector<int>& labels, const cv::Mat& points,
           const std::vector<MeanColor>& colors, const CameraIntrinsics& intrinsics,
           const Eigen::Vector3f& up, const OcclusionMergeOptions& options)
      : grid_(grid),
        options_(options),
        points_(points),
        up_(up),
        segments_(Collect(grid, labels, colors, intrinsics, up)),
        surfaces_(grid, segments_.voxels, kSameSurface),
        image_(LabelImage(grid, labels)),
        min_border_px_(ScaledPx(kMinBorderPx, points.cols, 4)),
        borders_(FindImageBorders(image_, points, ScaledPx(kBorderReachPx, points.cols, 2),
                                  kBorderStep)) {}

  const ImageBorders& Borders() const { return borders_; }

  // Pairs of segments of some size of which a third one hides parts.
  std::set<std::pair<int, int>> PairsWithCommonOccluder() const {
    std::map<int, std::vector<int>> hidden_by;
    for (const auto& [pair, border] : borders_) {
      InterruptionPoint();
      if (border.first_in_front >= min_border_px_) hidden_by[pair.first].push_back(pair.second);
      if (border.second_in_front >= min_border_px_) hidden_by[pair.second].push_back(pair.first);
    }
    std::set<std::pair<int, int>> pairs;
    for (auto& [front, hidden] : hidden_by) {
      std::erase_if(hidden, [&](int s) { return segments_.voxels[s].size() < kMinVoxels; });
      for (std::size_t i = 0; i < hidden.size(); ++i) {
        InterruptionPoint();
        for (std::size_t j = i + 1; j < hidden.size(); ++j) {
          pairs.insert(std::minmax(hidden[i], hidden[j]));
        }
      }
    }
    return pairs;
  }
  int NumSegments() const { return static_cast<int>(segments_.parts.size()); }

  // True if `front` hides a part of the border of `back`.
  bool Hides(int front, int back) const {
    const auto border = borders_.find(std::minmax(front, back));
    if (border == borders_.end()) return false;
    const int in_front =
        front < back ? border->second.first_in_front : border->second.second_in_front;
    return in_front >= min_border_px_;
  }

  bool AreOneBehindAnOccluder(int a, int b) const {
    if (segments_.parts[a].color.DistanceTo(segments_.parts[b].color) > kMaxColorDistance) {
      return false;
    }
    return surfaces_.AreOne(a, b, options_.min_shared_surface) &&
           ShareSeenThrough(image_, points_, a, b) <= kMaxSeenThrough;
  }

  bool IsInsideOf(int inside, int outside) const {
    if (options_.min_hollow_curvature_per_m <= 0) return false;
    const double curvature = segments_.roundness[inside].curvature_per_m;
    return -curvature >= options_.min_hollow_curvature_per_m && Hides(outside, inside) &&
           std::abs(segments_.parts[inside].Top_m() - segments_.parts[outside].Top_m()) <=
               kMaxRimStepM &&
           LiesAround(outside, segments_.roundness[inside]);
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
    const std::span<const int> voxels = segments_.voxels[segment];
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
  const Segments segments_;
  const SegmentSurfaces surfaces_;
  cv::Mat image_;
  int min_border_px_;
  ImageBorders borders_;
};

}  // namespace

std::vector<int> MergeOccluded(const VoxelGrid& grid, const std::vector<int>& labels,
                               const cv::Mat& points, const std::vector<MeanColor>& colors,
                               const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up,
                               const OcclusionMergeOptions& options) {
  if (options.min_shared_surface <= 0 && options.min_hollow_curvature_per_m <= 0) {
    return labels;
  }
  const Evidence evidence(grid, labels, points, colors, intrinsics, up, options);
  DisjointSets objects(evidence.NumSegments());
  for (const auto& [pair, border] : evidence.Borders()) {
    InterruptionPoint();
    const auto [a, b] = pair;
    if (evidence.IsInsideOf(a, b) || evidence.IsInsideOf(b, a)) objects.Join(a, b);
  }
  if (options.min_shared_surface > 0) {
    for (const auto& [a, b] : evidence.PairsWithCommonOccluder()) {
      InterruptionPoint();
      if (objects.Find(a) == objects.Find(b)) continue;
      if (evidence.AreOneBehindAnOccluder(a, b)) objects.Join(a, b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
