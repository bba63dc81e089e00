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

namespace fovea {
namespace {

constexpr int kBorderReachPx = 4;
constexpr float kBorderStep = 0.01F;
constexpr std::size_t kMaxSamples = 150;  // voxels of a segment that are compared

// An upright cylinder, from the regression of normals on positions in the horizontal plane.
struct Roundness {
  double curvature_per_m = 0;  // 1/R seen from outside, −1/R from inside, 0 for a plane
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();  // a point on it; only for a curvature not 0
};

struct Segment {
  std::vector<int> voxels;
  Roundness roundness;
  float top_m = -std::numeric_limits<float>::max();  // along `up`
};

Eigen::Vector3f Horizontal(const Eigen::Vector3f& v, const Eigen::Vector3f& up) {
  return v - up.dot(v) * up;
}

Roundness FitRoundness(const VoxelGrid& grid, const std::vector<int>& voxels,
                       const Eigen::Vector3f& up) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int v : voxels) {
    position += Horizontal(grid.voxels[v].mean, up).cast<double>();
    normal += Horizontal(grid.voxels[v].normal, up).cast<double>();
  }
  position /= static_cast<double>(voxels.size());
  normal /= static_cast<double>(voxels.size());
  double covariance = 0;
  double variance = 0;
  for (const int v : voxels) {
    const Eigen::Vector3d offset = Horizontal(grid.voxels[v].mean, up).cast<double>() - position;
    covariance += offset.dot(Horizontal(grid.voxels[v].normal, up).cast<double>());
    variance += offset.squaredNorm();
  }
  if (variance == 0 || covariance == 0) return {};
  const double curvature = covariance / variance;  // normal = curvature · (position − axis)
  return {curvature, (position - normal / curvature).cast<float>()};
}

std::vector<Segment> Collect(const VoxelGrid& grid, const std::vector<int>& labels,
                             const Eigen::Vector3f& up) {
  std::vector<Segment> segments(CountLabels(labels) + 1);
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) {
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
        borders_(FindImageBorders(image_, points, kBorderReachPx, kBorderStep)) {}

  const ImageBorders& Borders() const { return borders_; }

  // Pairs of segments of some size of which a third one hides parts.
  std::set<std::pair<int, int>> PairsWithCommonOccluder() const {
    std::map<int, std::vector<int>> hidden_by;
    for (const auto& [pair, border] : borders_) {
      if (border.first_in_front >= kMinBorderPx) hidden_by[pair.first].push_back(pair.second);
      if (border.second_in_front >= kMinBorderPx) hidden_by[pair.second].push_back(pair.first);
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
    return in_front >= kMinBorderPx;
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
           LiesAround(outside, segments_[inside].roundness.axis, -1 / curvature);
  }

 private:
  static constexpr int kMinBorderPx = 10;
  static constexpr std::size_t kMinVoxels = 10;
  // Of the inside's radius: how far from the axis the outside lies on average, at least and at
  // most, and how much of it has to lie within the latter.
  static constexpr double kMinShare = 0.25;
  static constexpr double kMaxShare = 1.1;
  static constexpr double kMinWithin = 0.75;

  // True if the segment is about as far from an axis as the wall around it is: a bowl's outside is
  // narrower below its rim, something beside the bowl is farther away.
  bool LiesAround(int segment, const Eigen::Vector3f& axis, double radius_m) const {
    double sum = 0;
    int num_within = 0;
    for (const int v : segments_[segment].voxels) {
      const double radius = (Horizontal(grid_.voxels[v].mean, up_) - axis).norm();
      sum += radius;
      if (radius <= kMaxShare * radius_m) ++num_within;
    }
    const auto count = static_cast<double>(segments_[segment].voxels.size());
    const double share = sum / count / radius_m;
    return share >= kMinShare && share <= kMaxShare && num_within >= kMinWithin * count;
  }

  const VoxelGrid& grid_;
  const OcclusionMergeOptions& options_;
  const cv::Mat& points_;
  const Eigen::Vector3f up_;
  std::vector<Segment> segments_;
  std::vector<MeanColor> colors_;
  cv::Mat image_;
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
