#include "core/detector.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <utility>

#include "core/depth/back_projection.h"
#include "core/depth/flying_pixels.h"
#include "core/depth/measured_depth.h"
#include "core/explanation.h"
#include "core/grasping/plan_grasps.h"
#include "core/object_surroundings.h"
#include "core/objects/portions.h"
#include "core/paper/detect_as_paper.h"
#include "core/pixel_blocks.h"
#include "core/planning/collision_primitives.h"
#include "core/planning/height_map.h"
#include "core/refinement.h"
#include "core/relations/blocked_by.h"
#include "core/relations/free_places.h"
#include "core/relations/leans_on.h"
#include "core/saliency/mean_saliency.h"
#include "core/scene/background.h"
#include "core/scene_geometry.h"
#include "core/seeds/salient_positions.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/contraction.h"
#include "core/segmentation/labels.h"
#include "core/stage_clock.h"
#include "core/types/interruption.h"
#include "core/types/time_budget.h"

namespace fovea {
namespace {

// Of lambda: cutting between voxels of one cluster costs at least as much.
constexpr double kMinShareOfCluster = 0.6;

// Returns false where the budget ended before the work did, and lifts it for what is left to do.
// Throws Cancelled where the caller wants no more.
bool InTime(TimeBudget& budget, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Cancelled&) {
    if (budget.IsStopped()) throw;
    budget.Lift();
    return false;
  }
}

// In one sweep, which does nearly all that more would.
std::vector<int> LabelVoxels(const PottsEnergy& energy, const MrfOptions& options) {
  const auto min_weight = static_cast<float>(kMinShareOfCluster * options.lambda);
  const Contraction clusters = Contract(energy, options.cluster_voxels, min_weight);
  return Expand(clusters, MinimizeByAlphaExpansion(clusters.energy, 1));
}

struct Salience {
  cv::Mat color, depth;  // CV_32FC1
};

// Section 3.1: where something stands out, in colour and in depth. The first stage of `clock`,
// "color_saliency", has begun.
Salience FindSalience(const RgbdFrame& frame, const cv::Mat& depth, const DetectorOptions& options,
                      StageClock& clock) {
  Salience salience;
  salience.color = StrengthSaliency(frame.color_rgb, options.color_saliency);
  clock.Begin("depth_saliency");
  salience.depth = DepthSaliency(depth, options.depth_saliency);
  return salience;
}

// What is not to be looked at, each time (portions.h). Portions cost more than the whole.
std::vector<std::vector<char>> PortionsInTime(const SceneGeometry& scene, const cv::Mat& saliency,
                                              const TimeBudget& budget) {
  // The rest takes up to twice the time of what comes before it; in noise more.
  constexpr double kAmple = 2.5;
  constexpr int kNumPortions = 4;
  if (budget.HasMoreLeftThan(kAmple)) return {scene.is_background};
  return SalientPortions(scene.grid, scene.is_background, saliency, kNumPortions);
}

// What has been found in the parts of a scene that were looked at, of which the last one is seen in
// a trace.
struct FoundObjects : RefinedScene {
  explicit FoundObjects(std::size_t num_voxels = 0) { objects.resize(num_voxels, 0); }

  void Add(std::vector<int> labels_of_part, RefinedScene part) {
    const int num_before = static_cast<int>(confidences.size());
    for (std::size_t v = 0; v < objects.size(); ++v) {
      if (part.objects[v] > 0) objects[v] = num_before + part.objects[v];
    }
    confidences.insert(confidences.end(), part.confidences.begin(), part.confidences.end());
    rejected.insert(rejected.end(), part.rejected.begin(), part.rejected.end());
    std::stable_sort(rejected.begin(), rejected.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    num_segments += part.tree.num_segments;
    num_merged += part.num_merged;
    labels = std::move(labels_of_part);
    segments = std::move(part.segments);
    tree = std::move(part.tree);
    evidence = std::move(part.evidence);
  }

  std::vector<int> labels;
  std::size_t num_segments = 0;
};

// What is found in a frame of blocks of pixels.
struct Search {
  cv::Mat depth;  // CV_32FC1 after hole filling, NaN = none
  SceneGeometry scene;
  Salience salience;
  SalientPositions salient;
  std::vector<Seed> seeds;  // that became object hypotheses
  cv::Mat saliency;         // of both maps
  FoundObjects found;
};

// `frame`: in blocks; `camera`: of the pixels of the region of interest. The first stage of `clock`
// has begun.
Search SearchInBlocks(const RgbdFrame& frame, const CameraIntrinsics& camera,
                      const DetectorOptions& options, TimeBudget& budget, StageClock& clock,
                      Detections& result) {
  Diagnostics& counts = result.diagnostics;
  Search search;

  // Section 1: the smoothed depth image and the point cloud.
  search.depth = FillDepthHoles(frame.depth_m, options.depth_fill);
  InterruptionPoint();
  const cv::Mat points = BackProject(search.depth, frame.intrinsics, options.max_depth_m);

  // What the scene consists of, and where something in it stands out: neither needs the other.
  SceneGeometry& scene = search.scene;
  const auto find_geometry = [&](StageClock& own) {
    scene = FindGeometry(frame, search.depth, points, camera, options, own);
  };
  const auto find_salience = [&](StageClock& own) {
    search.salience = FindSalience(frame, search.depth, options, own);
  };
  clock.RunBranches({{"normals", find_geometry}, {"color_saliency", find_salience}});
  result.gravity = scene.gravity;
  if (!scene.supports.empty()) result.support = scene.supports.front().surface;
  clock.Begin("seeds");

  // Section 3: seeds all over what stands above a support or, where there is none, at what stands
  // out; and the scene as voxels, labelled by a Markov random field.
  if (scene.supports.empty()) {
    search.salient = FindSalientPositions(search.salience.color, options.color_saliency.downscale,
                                          search.salience.depth, options.depth_saliency.downscale,
                                          points, options.seeds, counts);
  }
  search.seeds =
      CoverWithSeeds(scene.grid, scene.is_background, search.salient.seeds, options.cover);
  counts.num_seeds = search.seeds.size();
  counts.num_voxels = scene.grid.voxels.size();
  search.found = FoundObjects(scene.grid.voxels.size());
  const auto look_at = [&](const std::vector<char>& is_background) {
    clock.Begin("energy");
    const PottsEnergy energy = BuildEnergy(scene.grid, scene.points, scene.colors, is_background,
                                           search.seeds, options.mrf);
    clock.Begin("graph_cut");
    const std::vector<int> labels = LabelVoxels(energy, options.mrf);
    clock.Begin("refinement");
    // Section 3.3: segments that look alike are one object.
    search.found.Add(labels, Refine({scene.grid, labels, scene.points, scene.lab, scene.colors,
                                     frame.intrinsics, -scene.gravity.direction, scene.supports,
                                     scene.standing, scene.on_wall, frame.unseen},
                                    options));
  };
  search.saliency = MeanSaliency(search.salience.color, search.salience.depth);
  for (const std::vector<char>& outside : PortionsInTime(scene, search.saliency, budget)) {
    if (result.incomplete) break;
    result.incomplete = !InTime(budget, [&] { look_at(outside); });
  }
  budget.Lift();
  counts.num_segments = search.found.num_segments;
  counts.num_merged = search.found.num_merged;
  counts.segments_implausible = search.found.rejected.size();
  return search;
}

// Of a search whose voxels have their pixels. `depth`: of these, NaN = none.
Trace TraceOf(Search search, const cv::Mat& depth, const PixelBlocks& blocks,
              const DetectorOptions& options) {
  FoundObjects& found = search.found;
  std::vector<RemovedSeed>& removed = search.salient.removed;
  for (Seed& seed : search.seeds) seed.pixel = blocks.InPixels(seed.pixel);
  for (RemovedSeed& seed : removed) seed.pixel = blocks.InPixels(seed.pixel);
  const std::vector<int> merged =
      LabelsOfChosen(found.tree, found.tree.LikelyNodes(), found.segments);
  return {FillFromBlocks(depth, search.depth, blocks),
          blocks.InPixels(search.salience.color),
          blocks.InPixels(search.salience.depth),
          std::move(search.seeds),
          std::move(removed),
          options.mrf.data.gamma_per_m2,
          std::move(search.scene.grid),
          std::move(search.scene.colors),
          std::move(found.labels),
          std::move(found.segments),
          merged,
          std::move(found.tree),
          std::move(found.evidence),
          blocks.InPixels(search.scene.standing),
          {}};
}

// NaN elsewhere.
cv::Mat DepthWhere(const cv::Mat& mask, const cv::Mat& depth) {
  cv::Mat result(depth.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  depth.copyTo(result, mask);
  return result;
}

// The first stage of `clock` has begun.
ObjectSurroundings FindObjects(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                               TimeBudget& budget, StageClock& clock, Detections& result) {
  Diagnostics& counts = result.diagnostics;
  const cv::Mat measured = MeasuredDepth(frame.depth_m);
  const cv::Mat depth = RemoveFlyingPixels(measured, frame.intrinsics.fx_px, frame.intrinsics.fy_px,
                                           options.flying_pixels);
  InterruptionPoint();
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_too_far = CountBeyond(measured, options.max_depth_m);
  counts.num_points = CountMeasured(depth) - CountBeyond(depth, options.max_depth_m);

  const PixelBlocks blocks = BlocksOf(frame, options.voxels);
  Search search = SearchInBlocks(InBlocks(frame, depth, blocks), frame.intrinsics, options, budget,
                                 clock, result);
  clock.Begin("objects");

  SceneGeometry& scene = search.scene;
  result.rejected = search.found.rejected;
  for (RejectedObject& rejected : result.rejected) {
    rejected.bounds_px = blocks.InPixels(rejected.bounds_px);
  }
  // Pixels show what was measured there, and what stands in for what cannot be.
  const cv::Mat depth_of_blocks = ChannelZ(scene.points);
  const cv::Mat shown = FillFromBlocks(depth, DepthWhere(scene.standing, depth_of_blocks), blocks);
  const cv::Mat points = BackProject(shown, frame.intrinsics, options.max_depth_m);
  scene.grid.voxel_of_pixel =
      VoxelsOfPixels(scene.grid.voxel_of_pixel, depth_of_blocks, depth, blocks);
  result.labels = LabelsWithin(scene.grid, search.found.objects, shown <= options.max_depth_m);
  DescribeObjects(frame, points, blocks.InPixels(search.saliency), search.found.confidences,
                  scene.supports, options.objects, result);
  clock.Finish();
  std::vector<Support> supports = std::move(scene.supports);
  if (trace != nullptr) *trace = TraceOf(std::move(search), depth, blocks, options);
  return {points, std::move(supports)};
}

void PrepareForPlanning(const ObjectSurroundings& around, const PlanningOptions& options,
                        Detections& result) {
  if (options.collision_primitives) {
    for (DetectedObject& object : result.objects) object.collision = PrimitiveOf(object);
    for (const Support& support : around.supports) {
      result.support_collisions.push_back(PrimitiveOf(support, around.points));
    }
  }
  if (options.height_map) {
    const Eigen::Vector3f up = result.support ? result.support->normal : -result.gravity.direction;
    const float offset_m = result.support ? result.support->offset_m : 0;
    result.height_map = MakeHeightMap(around.points, up, offset_m, options);
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
        FindFreePlaces(around.points, around.supports, result.objects, *options.place);
  }
  const PlanningOptions& planning = options.planning;
  if (planning.collision_primitives || planning.height_map) {
    clock.Begin("planning");
    PrepareForPlanning(around, planning, result);
  }
  if (!options.grippers.empty()) {
    clock.Begin("grasps");
    PlanGrasps({around.points, result.labels, frame.intrinsics, -result.gravity.direction},
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
  RequireNotEmpty(options.paper ? options.paper->region : options.region, frame.depth_m.size());
  Detections result;
  TimeBudget budget(options.time_budget, should_stop);
  const InterruptionScope interruption([&] { return budget.WantsStop(); });
  StageClock clock("depth");
  try {
    const bool in_time = InTime(budget, [&] {
      const ObjectSurroundings around =
          options.paper ? paper::FindObjects(frame, *options.paper, trace, clock, result)
                        : FindObjects(frame, options, trace, budget, clock, result);
      AnswerRobot(frame, around, options, trace, clock, result);
    });
    if (!in_time) result = NothingYet(frame);
  } catch (Cancelled& cancelled) {
    cancelled.stage_times = clock.TimesUntilNow();
    throw;
  }
  result.diagnostics.messages = ExplainLosses(result);
  result.grippers = options.grippers;
  result.stage_times = clock.TimesUntilNow();
  return result;
}

}  // namespace fovea
