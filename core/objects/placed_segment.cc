#include "core/objects/placed_segment.h"

#include <algorithm>
#include <optional>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// The smallest distance of a point below a support that covers it.
std::optional<float> DepthBelowSupport(const std::vector<Support>& supports,
                                       const Eigen::Vector3f& point,
                                       const SupportOptions& options) {
  const float tolerance = SupportTolerance(point.z(), options);
  std::optional<float> nearest;
  for (const Support& support : supports) {
    const float depth = -support.surface.HeightOf(point);
    if (depth > support.LargestShare() * tolerance && support.footprint.Covers(point))
      nearest = std::min(depth, nearest.value_or(depth));
  }
  return nearest;
}

}  // namespace

std::vector<PlacedSegment> PlaceSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                         const std::vector<Support>& supports,
                                         const SupportOptions& options) {
  std::vector<PlacedSegment> segments(CountLabels(labels) + 1);
  LongLoop loop;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    loop.Turn();
    if (labels[v] == 0) continue;
    const Eigen::Vector3f& point = grid.voxels[v].mean;
    PlacedSegment& segment = segments[labels[v]];
    segment.points.push_back(point);
    segment.num_pixels += grid.voxels[v].num_points;
    if (const auto below = SupportBelow(supports, point, options)) {
      const Support& support = supports[*below];
      const float height_m = support.surface.HeightOf(point);
      ++segment.num_above[{*below, support.footprint.PartAt(point)}];
      segment.lowest_m = std::min(segment.lowest_m, height_m);
      segment.highest_m = std::max(segment.highest_m, height_m);
      const float noise_m = support.LargestShare() * SupportTolerance(point.z(), options);
      segment.rise = std::max(segment.rise, height_m / noise_m);
    }
    if (const auto depth = DepthBelowSupport(supports, point, options)) {
      ++segment.num_covered;
      segment.least_depth_m = std::min(segment.least_depth_m, *depth);
    }
  }
  return segments;
}

}  // namespace fovea
