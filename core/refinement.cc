#include "core/refinement.h"

#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/round_wall_merge.h"

namespace fovea {
namespace {

// Segments that are parts of one object.
std::vector<int> Merge(const LabelledScene& scene, const std::vector<int>& segments,
                       const DetectorOptions& options) {
  const auto& [grid, labels, points, colors, intrinsics, up, supports, on_wall] = scene;
  std::vector<int> objects = MergeParts(grid, segments, colors, intrinsics, up, options.part_merge);
  objects = MergeOccluded(grid, objects, points, colors, intrinsics, up, options.occlusion_merge);
  return MergeUnstable(grid, objects, points, intrinsics, supports, options.support, up,
                       options.stability_merge);
}

}  // namespace

RefinedScene Refine(const LabelledScene& scene, const DetectorOptions& options) {
  const auto& [grid, labels, points, colors, intrinsics, up, supports, on_wall] = scene;
  RefinedScene result;
  result.segments = SplitIntoSegments(grid, labels);
  result.num_segments = CountLabels(result.segments);
  RequireFewSegments(result.segments);

  const std::vector<int> pieces = result.segments;
  RoundWalls walls;
  if (!supports.empty()) {
    walls = FindRoundWalls(grid, pieces, up, options.hollow_fill.max_radius_m);
    result.segments = MergeRoundWalls(pieces, walls);
  }
  result.objects = Merge(scene, result.segments, options);
  result.num_merged = result.num_segments - CountLabels(result.objects);
  result.merged = result.objects;
  if (supports.empty()) return result;

  result.merged = FillHollows(grid, result.objects, pieces, walls, points, intrinsics, on_wall, up);
  const PlausibleSegments plausible = RemoveImplausible(
      grid, result.merged, points, intrinsics, supports, options.support, options.plausibility);
  const PlausibleSegments ended = RemoveContinued(grid, plausible.labels, points, intrinsics,
                                                  on_wall, up, options.continuation);
  result.objects = ended.labels;
  result.num_implausible = plausible.num_removed + ended.num_removed;
  return result;
}

}  // namespace fovea
