#include "core/detector.h"

#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <utility>

#include "core/depth/back_projection.h"
#include "core/depth/flying_pixels.h"
#include "core/depth/measured_depth.h"
#include "core/explanation.h"
#include "core/exposure.h"
#include "core/grasping/plan_grasps.h"
#include "core/object_surroundings.h"
#include "core/objects/mask_holes.h"
#include "core/paper/detect_as_paper.h"
#include "core/pixel_blocks.h"
#include "core/planning/collision_primitives.h"
#include "core/planning/height_map.h"
#include "core/relations/blocked_by.h"
#include "core/relations/free_places.h"
#include "core/relations/leans_on.h"
#include "core/scene/background.h"
#include "core/search.h"
#include "core/segmentation/labels.h"
#include "core/stage_clock.h"
#include "core/types/interruption.h"
#include "core/types/time_budget.h"

namespace fovea {
namespace {

// `depth`: of the pixels, NaN = none.
Trace TraceOf(Search search, const cv::Mat& depth, const PixelBlocks& blocks,
              const DetectorOptions& options) {
  FoundObjects& found = search.found;
  std::vector<RemovedSeed>& removed = search.salient.removed;
  for (Seed& seed : search.seeds) seed.pixel = blocks.InPixels(seed.pixel);
  for (RemovedSeed& seed : removed) seed.pixel = blocks.InPixels(seed.pixel);
  const std::vector<int> merged =
      LabelsOfChosen(found.tree, found.tree.LikelyNodes(), found.segments);
  search.scene.grid.voxel_of_pixel = blocks.InPixels(search.scene.grid.voxel_of_pixel);
  const cv::Mat everywhere = search.depth == search.depth;
  return {
      .depth_m = FillFromBlocks(depth, search.depth, everywhere, blocks),
      .color_saliency = blocks.InPixels(search.salience.color),
      .depth_saliency = blocks.InPixels(search.salience.depth),
      .seeds = std::move(search.seeds),
      .removed = std::move(removed),
      .gamma_per_m2 = options.mrf.data.gamma_per_m2,
      .voxels = std::move(search.scene.grid),
      .colors = std::move(search.scene.colors),
      .labels = std::move(found.labels),
      .segments = std::move(found.segments),
      .merged = merged,
      .tree = std::move(found.tree),
      .evidence = std::move(found.evidence),
      .standing = blocks.InPixels(search.scene.standing),
      .grasp_candidates = {},
  };
}

// Whether anything beside the objects themselves needs the points around them.
bool NeedsSurroundings(const DetectorOptions& options) {
  return options.place || options.planning.collision_primitives || options.planning.height_map ||
         !options.grippers.empty();
}

// Of a time budget, for what is told of the objects that have been found: plain ones take less than
// a tenth, with grasps, places or maps about half.
double ShareOfAnswer(const DetectorOptions& options) {
  return NeedsSurroundings(options) ? 0.5 : 0.1;
}

// What is told of the supports, and of objects that stand on them, is of pixels, not of blocks.
void RefitToPixels(const PixelPoints& points, const PixelBlocks& blocks,
                   const SupportOptions& options, std::vector<Support>& supports,
                   Detections& result) {
  if (supports.empty() || blocks.edge_px == 1) return;
  RefitSurfaces(UnlabelledPoints(points, result.labels, blocks), options, supports);
  result.support = supports.front().surface;
}

// `frame`: its depth as of MeasuredDepth. The first stage of `clock` has begun.
ObjectSurroundings FindObjects(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                               TimeBudget& budget, StageClock& clock, Detections& result) {
  Diagnostics& counts = result.diagnostics;
  const cv::Mat& measured = frame.depth_m;
  const cv::Mat depth = RemoveFlyingPixels(measured, frame.intrinsics.fx_px, frame.intrinsics.fy_px,
                                           options.flying_pixels);
  InterruptionPoint();
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_too_far = counts.num_measured - CountUpTo(measured, options.max_depth_m);
  counts.num_points = CountUpTo(depth, options.max_depth_m);

  budget.KeepBack(ShareOfAnswer(options));
  const PixelBlocks blocks = BlocksOf(frame, options.voxels);
  RgbdFrame coarse = InBlocks(frame, depth, blocks);
  const WellExposed exposed = Expose(coarse.color_rgb);
  coarse.color_rgb = exposed.color_rgb;
  counts.color_is_blank = exposed.is_blank;
  Search search = SearchInBlocks(coarse, frame.intrinsics, options, budget, clock, result);
  clock.Begin("objects");

  SceneGeometry& scene = search.scene;
  result.rejected = search.found.rejected;
  for (RejectedObject& rejected : result.rejected) {
    rejected.bounds_px = blocks.InPixels(rejected.bounds_px);
  }
  // Pixels show what was measured there, and what stands in for what cannot be.
  const cv::Mat depth_of_blocks = ChannelZ(scene.points);
  const cv::Mat near = counts.num_too_far > 0 ? DepthUpTo(depth, options.max_depth_m) : depth;
  const cv::Mat shown = FillFromBlocks(near, depth_of_blocks, scene.standing, blocks);
  cv::Mat label_of_block = LabelImage(scene.grid, search.found.objects);
  FillMaskHoles(scene.lab, label_of_block);
  result.labels =
      LabelsOfPixels(label_of_block, depth_of_blocks, shown, options.max_depth_m, blocks);
  RefitToPixels({near, frame.intrinsics}, blocks, options.support, scene.supports, result);
  DescribeObjects(
      frame, {shown, frame.intrinsics}, {search.saliency, blocks.edge_px},
      {search.found.confidences, FindCutByRegion(scene.grid, search.found.objects,
                                                 search.found.confidences.size(), scene.hidden)},
      scene.supports, options.objects, result);
  ObjectSurroundings around;
  around.supports = std::move(scene.supports);
  if (NeedsSurroundings(options)) {
    around.points = BackProject(shown, frame.intrinsics, options.max_depth_m);
    around.measured_m = measured;
    if (cv::countNonZero(scene.standing) > 0) {
      around.assumed = ~(near == near) & (result.labels == 0);  // NaN is not equal to itself
    }
  }
  clock.Finish();
  if (trace != nullptr) *trace = TraceOf(std::move(search), depth, blocks, options);
  return around;
}

// Without the points that were assumed for what is no object: nobody saw anything there.
cv::Mat PointsOfMap(const ObjectSurroundings& around) {
  if (around.assumed.empty()) return around.points;
  cv::Mat points = around.points.clone();
  points.setTo(cv::Scalar::all(std::numeric_limits<double>::quiet_NaN()), around.assumed);
  return points;
}

void PrepareForPlanning(const ObjectSurroundings& around, const PlanningOptions& options,
                        Detections& result) {
  if (options.collision_primitives) {
    for (DetectedObject& object : result.objects) object.collision = PrimitiveOf(object);
    for (const Support& support : around.supports) {
      const auto below = PrimitiveOf(support, around.points);
      if (below) result.support_collisions.push_back(*below);
    }
  }
  if (options.height_map) {
    const Eigen::Vector3f up = result.support ? result.support->normal : -result.gravity.direction;
    const float offset_m = result.support ? result.support->offset_m : 0;
    result.height_map = MakeHeightMap(PointsOfMap(around), up, offset_m, options);
  }
}

// What a robot asks of the objects beside what they are.
void AnswerRobot(const RgbdFrame& frame, const ObjectSurroundings& around,
                 const DetectorOptions& options, Trace* trace, StageClock& clock,
                 Detections& result) {
  FindWhatLeans(-result.gravity.direction, result.objects);
  BlockByWhatStandsOn(result.objects);
  if (options.place) {
    clock.Begin("places");
    result.free_places =
        FindFreePlaces({frame, around.points, result.labels}, around.supports, result.objects,
                       *options.place, options.paper ? options.paper->support : options.support);
  }
  const PlanningOptions& planning = options.planning;
  if (planning.collision_primitives || planning.height_map) {
    clock.Begin("planning");
    PrepareForPlanning(around, planning, result);
  }
  if (!options.grippers.empty()) {
    clock.Begin("grasps");
    PlanGrasps({around.points, result.labels, frame.intrinsics, -result.gravity.direction,
                around.measured_m},
               options.grippers, result.objects,
               trace != nullptr ? &trace->grasp_candidates : nullptr);
  }
  clock.Finish();
}

Detections NothingYet(const RgbdFrame& frame) {
  Detections result;
  result.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
  result.incomplete = true;
  result.gravity = frame.gravity ? Gravity{frame.gravity->normalized(), Gravity::Source::kGiven}
                                 : Gravity{Eigen::Vector3f::UnitY(), Gravity::Source::kAssumed};
  return result;
}

}  // namespace

Detections Detect(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                  const std::function<bool()>& should_stop) {
  Validate(frame);
  Validate(options);
  const RegionOptions& region = options.paper ? options.paper->region : options.region;
  RequireNotEmpty(region, frame.depth_m.size());
  Detections result;
  TimeBudget budget(options.time_budget, should_stop);
  const InterruptionScope interruption([&] { return budget.WantsStop(); });
  StageClock clock("depth");
  try {
    const bool in_time = budget.Suffices([&] {
      RgbdFrame measured = frame;  // what no camera measures is none to all stages
      measured.depth_m = MeasuredDepth(frame.depth_m);
      const ObjectSurroundings around =
          options.paper ? paper::FindObjects(measured, *options.paper, trace, clock, result)
                        : FindObjects(measured, options, trace, budget, clock, result);
      AnswerRobot(measured, around, options, trace, clock, result);
    });
    if (!in_time) result = NothingYet(frame);
  } catch (Cancelled& cancelled) {
    cancelled.stage_times = clock.TimesUntilNow();
    throw;
  }
  result.diagnostics.messages = ExplainLosses(
      result, {.region = region != RegionOptions(), .place = options.place.has_value()});
  result.grippers = options.grippers;
  result.stage_times = clock.TimesUntilNow();
  return result;
}

}  // namespace fovea
