#include "core/objects/plausibility.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/objects/oriented_box.h"
#include "core/segmentation/contacts.h"
#include "core/segmentation/labels.h"

namespace fovea {
namespace {

constexpr float kMinBack_m = 0.3F;  // width of the back of a chair

struct Segment {
  std::vector<Eigen::Vector3f> points;                 // means of its voxels
  float lowest_m = std::numeric_limits<float>::max();  // above the support below it
  std::vector<int> num_above;                          // of its voxels, by the support below
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
      segment.num_above.resize(supports.size());
      ++segment.num_above[*below];
      segment.lowest_m = std::min(segment.lowest_m, supports[*below].surface.HeightOf(point));
    }
    if (const auto depth = DepthBelowSupport(supports, point, support_options)) {
      ++segment.num_covered;
      segment.least_depth_m = std::min(segment.least_depth_m, *depth);
    }
  }
  return segments;
}

// As large as what it stands on, if that is not the dominating surface, whose other parts may hide.
bool IsPartOfItsSupport(const Segment& segment, const Eigen::Vector3f& size_m,
                        const std::vector<Support>& supports, double max_support_share) {
  const float width_m = size_m.head<2>().maxCoeff();
  const auto most = std::max_element(segment.num_above.begin(), segment.num_above.end());
  if (most == segment.num_above.begin() || most == segment.num_above.end()) return false;
  const Support& support = supports[most - segment.num_above.begin()];
  return width_m >= kMinBack_m &&
         width_m * size_m.z() > max_support_share * support.footprint.AreaM2();
}

bool IsTooLarge(const Segment& segment, const std::vector<Support>& supports,
                const PlausibilityOptions& options) {
  const Eigen::Vector3f up = supports.front().surface.normal;
  const Eigen::Vector3f size_m = FitOrientedBox(segment.points, up, std::nullopt).size_m;
  return size_m.maxCoeff() > options.max_size_m || size_m.z() > options.max_height_m ||
         IsPartOfItsSupport(segment, size_m, supports, options.max_support_share);
}

// Most of it lies under a support, and it reaches up to it.
bool Hangs(const Segment& segment, double max_hang_m) {
  return 2 * segment.num_covered > segment.points.size() && segment.least_depth_m < max_hang_m;
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
                                    const std::vector<Support>& supports,
                                    const SupportOptions& support_options,
                                    const PlausibilityOptions& options) {
  PlausibleSegments result{labels, 0};
  if (supports.empty()) return result;
  const std::vector<Segment> segments = Collect(grid, labels, supports, support_options);
  std::vector<char> stays(segments.size(), 0);
  std::vector<char> rests(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    stays[label] = !IsTooLarge(segments[label], supports, options) &&
                   !Hangs(segments[label], options.max_hang_m);
    rests[label] = segments[label].lowest_m <= options.max_rest_m;
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
