#include "core/refinement.h"

#include <cstdint>
#include <limits>

#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/round_wall_merge.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

// Images of labels have 16 bits.
void RequireFewSegments(std::size_t num_segments) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  if (num_segments <= kMax) return;
  throw TooComplex(
      "segments: more than 65535, depth is mostly noise; raise voxels.size_m or cover.min_voxels");
}

// Segments that are parts of one object.
std::vector<int> Merge(const LabelledScene& scene, const std::vector<int>& segments,
                       const DetectorOptions& options) {
  const auto& [grid, labels, points, color_rgb, colors, intrinsics, up, supports, on_wall] = scene;
  std::vector<int> objects = MergeParts(grid, segments, colors, intrinsics, up, options.part_merge);
  objects = MergeOccluded(grid, objects, points, colors, intrinsics, up, options.occlusion_merge);
  return MergeUnstable(grid, objects, points, intrinsics, supports, options.support, up,
                       options.stability_merge);
}

}  // namespace

RefinedScene Refine(const LabelledScene& scene, const DetectorOptions& options) {
  const auto& [grid, labels, points, color_rgb, colors, intrinsics, up, supports, on_wall] = scene;
  RefinedScene result;
  result.segments = SplitIntoSegments(grid, labels);
  result.num_segments = CountLabels(result.segments);
  RequireFewSegments(result.num_segments);
  result.segments = MergeByColor(grid, result.segments, color_rgb, options.color_merge);

  const std::vector<int> pieces = result.segments;
  RoundWalls walls;
  if (!supports.empty()) {
    walls = FindRoundWalls(grid, pieces, up, options.hollow_fill.max_radius_m);
    result.segments = MergeRoundWalls(pieces, walls);
  }
  result.objects = Merge(scene, result.segments, options);
  result.num_merged = result.num_segments - CountLabels(result.objects);
  if (supports.empty()) return result;

  result.objects =
      FillHollows(grid, result.objects, pieces, walls, points, intrinsics, on_wall, up);
  const PlausibleSegments plausible = RemoveImplausible(
      grid, result.objects, points, intrinsics, supports, options.support, options.plausibility);
  const PlausibleSegments ended = RemoveContinued(grid, plausible.labels, points, intrinsics,
                                                  on_wall, up, options.continuation);
  result.objects = ended.labels;
  result.num_implausible = plausible.num_removed + ended.num_removed;
  return result;
}

}  // namespace fovea
