#include "core/objects/plausibility.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/objects/oriented_box.h"
#include "core/scene/level_axes.h"
#include "core/segmentation/contacts.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/lower_border.h"

namespace fovea {
namespace {

constexpr float kMinBack_m = 0.3F;     // width of the back of a chair
constexpr float kLegMargin_m = 0.04F;  // between what is seen of one leg
constexpr float kLifted_m = 0.1F;      // above a support, beyond what noise hides

// A support and a connected part of its footprint, by their numbers.
using SupportPart = std::pair<std::size_t, int>;

struct Segment {
  std::vector<Eigen::Vector3f> points;                 // means of its voxels
  float lowest_m = std::numeric_limits<float>::max();  // above the support below it
  float highest_m = 0;                                 // likewise
  // How many of its voxels are above each part of each support.
  std::map<SupportPart, int> num_above;
  // Of the voxels that a support covers from above: how many, and the least distance to it.
  std::size_t num_covered = 0;
  float least_depth_m = std::numeric_limits<float>::max();
};

// The smallest distance of a point below a support that covers it.
std::optional<float> DepthBelowSupport(const std::vector<Support>& supports,
                                       const Eigen::Vector3f& point,
                                       const SupportOptions& options) {
  const float tolerance = SupportTolerance(point.z(), options);
  std::optional<float> nearest;
  for (const Support& support : supports) {
    const float depth = -support.surface.HeightOf(point);
    if (depth > tolerance && support.footprint.Covers(point))
      nearest = std::min(depth, nearest.value_or(depth));
  }
  return nearest;
}

std::vector<Segment> Collect(const VoxelGrid& grid, const std::vector<int>& labels,
                             const std::vector<Support>& supports,
                             const SupportOptions& support_options) {
  std::vector<Segment> segments(CountLabels(labels) + 1);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == 0) continue;
    const Eigen::Vector3f& point = grid.voxels[v].mean;
    Segment& segment = segments[labels[v]];
    segment.points.push_back(point);
    if (const auto below = SupportBelow(supports, point, support_options)) {
      ++segment.num_above[{*below, supports[*below].footprint.PartAt(point)}];
      const float height_m = supports[*below].surface.HeightOf(point);
      segment.lowest_m = std::min(segment.lowest_m, height_m);
      segment.highest_m = std::max(segment.highest_m, height_m);
    }
    if (const auto depth = DepthBelowSupport(supports, point, support_options)) {
      ++segment.num_covered;
      segment.least_depth_m = std::min(segment.least_depth_m, *depth);
    }
  }
  return segments;
}

// The area of what a segment stands on; none where that is the largest part of the dominating
// surface, much of which may hide, or is unbounded.
std::optional<double> AreaOfItsSupportM2(const Segment& segment,
                                         const std::vector<Support>& supports) {
  const auto most =
      std::max_element(segment.num_above.begin(), segment.num_above.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == segment.num_above.end()) return std::nullopt;
  const auto& [support, part] = most->first;
  const std::vector<double>& areas = supports[support].footprint.PartAreasM2();
  if (areas.empty()) return std::nullopt;
  const double largest = *std::max_element(areas.begin(), areas.end());
  if (support == 0 && areas[part] == largest) return std::nullopt;
  return areas[part];
}

// As large as what it stands on.
bool IsPartOfItsSupport(const Segment& segment, const Eigen::Vector3f& size_m,
                        const std::vector<Support>& supports, double max_support_share) {
  const float width_m = size_m.head<2>().maxCoeff();
  if (width_m < kMinBack_m) return false;
  const std::optional<double> area_m2 = AreaOfItsSupportM2(segment, supports);
  return area_m2 && width_m * size_m.z() > max_support_share * *area_m2;
}

bool IsTooLarge(const Segment& segment, const std::vector<Support>& supports,
                const PlausibilityOptions& options) {
  const Eigen::Vector3f up = supports.front().surface.normal;
  const Eigen::Vector3f size_m = FitOrientedBox(segment.points, up, std::nullopt).size_m;
  return size_m.maxCoeff() > options.max_size_m || size_m.z() > options.max_height_m ||
         IsPartOfItsSupport(segment, size_m, supports, options.max_support_share);
}

// Most of it lies under a support.
bool IsCovered(const Segment& segment) { return 2 * segment.num_covered > segment.points.size(); }

Eigen::AlignedBox2f SeenFromAbove(const Segment& segment, const LevelAxes& axes) {
  Eigen::AlignedBox2f box;
  for (const Eigen::Vector3f& point : segment.points) box.extend(Eigen::Vector2f(axes * point));
  return box;
}

// Segments that reach up to a support that covers them, and what is covered and stands right below
// one of them: the lower end of a leg.
std::vector<char> FindHanging(const std::vector<Segment>& segments, const Eigen::Vector3f& up,
                              double max_hang_m) {
  const LevelAxes axes = LevelAxesFor(up);
  std::vector<char> hang(segments.size(), 0);
  std::vector<Eigen::AlignedBox2f> legs;
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const Segment& segment = segments[label];
    if (!IsCovered(segment) || segment.least_depth_m >= max_hang_m) continue;
    hang[label] = 1;
    Eigen::AlignedBox2f& leg = legs.emplace_back(SeenFromAbove(segment, axes));
    leg.min().array() -= kLegMargin_m;
    leg.max().array() += kLegMargin_m;
  }
  for (std::size_t label = 1; label < segments.size(); ++label) {
    if (hang[label] || !IsCovered(segments[label])) continue;
    const Eigen::AlignedBox2f box = SeenFromAbove(segments[label], axes);
    hang[label] = std::any_of(legs.begin(), legs.end(),
                              [&](const Eigen::AlignedBox2f& leg) { return leg.contains(box); });
  }
  return hang;
}

// Segments high above their support that end higher than an object can, where nothing is seen right
// below them: something in front hides it, or one sees past.
std::vector<char> FindTooHigh(const std::vector<Segment>& segments, const cv::Mat& labels,
                              const cv::Mat& points, const CameraIntrinsics& intrinsics,
                              const Eigen::Vector3f& up, double max_height_m) {
  std::vector<char> too_high(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const Segment& segment = segments[label];
    too_high[label] = segment.lowest_m > kLifted_m && segment.highest_m > max_height_m;
  }
  if (std::count(too_high.begin(), too_high.end(), 1) == 0) return too_high;
  const std::vector<LowerBorder> borders =
      FindLowerBorders(labels, points, intrinsics, up, too_high);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const LowerBorder& border = borders[label];
    if (2 * (border.num_free + border.num_hidden) <= border.num_pixels) too_high[label] = 0;
  }
  return too_high;
}

// Segments that touch one that rests, directly or through others, rest too.
void SpreadRest(const VoxelGrid& grid, const std::vector<int>& labels,
                const std::vector<char>& stays, std::vector<char>& rests) {
  constexpr int kTouchCells = 2;
  if (std::all_of(rests.begin() + 1, rests.end(), [](char rest) { return rest != 0; })) return;
  const std::vector<VoxelEdge> contacts = FindContacts(grid, labels, kTouchCells);
  for (bool changed = true; changed;) {
    changed = false;
    for (const VoxelEdge& contact : contacts) {
      const int a = labels[contact.a];
      const int b = labels[contact.b];
      if (!stays[a] || !stays[b] || rests[a] == rests[b]) continue;
      rests[a] = rests[b] = 1;
      changed = true;
    }
  }
}

}  // namespace

PlausibleSegments RemoveImplausible(const VoxelGrid& grid, const std::vector<int>& labels,
                                    const cv::Mat& points, const CameraIntrinsics& intrinsics,
                                    const std::vector<Support>& supports,
                                    const SupportOptions& support_options,
                                    const PlausibilityOptions& options) {
  PlausibleSegments result{labels, 0};
  if (supports.empty()) return result;
  const std::vector<Segment> segments = Collect(grid, labels, supports, support_options);
  const Eigen::Vector3f& up = supports.front().surface.normal;
  const std::vector<char> hang = FindHanging(segments, up, options.max_hang_m);
  const std::vector<char> too_high =
      FindTooHigh(segments, LabelImage(grid, labels), points, intrinsics, up, options.max_height_m);
  std::vector<char> stays(segments.size(), 0);
  std::vector<char> rests(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    stays[label] = !hang[label] && !IsTooLarge(segments[label], supports, options);
    rests[label] = !too_high[label] && segments[label].lowest_m <= options.max_rest_m;
  }
  SpreadRest(grid, labels, stays, rests);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    if (!stays[label] || !rests[label]) ++result.num_removed;
  }
  for (int& label : result.labels) {
    if (label != 0 && !(stays[label] && rests[label])) label = 0;
  }
  return result;
}

}  // namespace fovea
