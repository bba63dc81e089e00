#include "core/detector.h"

#include <opencv2/core.hpp>

#include "core/depth/back_projection.h"
#include "core/depth/flying_pixels.h"
#include "core/depth/measured_depth.h"
#include "core/explanation.h"
#include "core/paper/detect_as_paper.h"
#include "core/refinement.h"
#include "core/saliency/mean_saliency.h"
#include "core/scene/background.h"
#include "core/scene/missing_depth.h"
#include "core/seeds/salient_positions.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/contraction.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/stage_clock.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

void AddWalls(const std::vector<char>& on_wall, std::vector<char>& is_background) {
  for (std::size_t v = 0; v < on_wall.size(); ++v) is_background[v] |= on_wall[v];
}

// Of lambda: cutting between voxels of one cluster costs at least as much.
constexpr double kMinShareOfCluster = 0.6;

std::vector<int> LabelClusters(const PottsEnergy& energy, const MrfOptions& options) {
  const auto min_weight = static_cast<float>(kMinShareOfCluster * options.lambda);
  const Contraction clusters = Contract(energy, options.cluster_voxels, min_weight);
  return Expand(clusters, MinimizeByAlphaExpansion(clusters.energy, 1));
}

// The first sweep, which costs the most, is over clusters; later ones are over single voxels.
std::vector<int> LabelVoxels(const PottsEnergy& energy, const MrfOptions& options) {
  const std::vector<int> labels = options.cluster_voxels > 1 ? LabelClusters(energy, options)
                                                             : MinimizeByAlphaExpansion(energy, 1);
  return ImproveByAlphaExpansion(energy, labels, options.max_sweeps - 1);
}

// The first stage of `clock` has begun.
void FindObjects(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                 StageClock& clock, Detections& result) {
  Diagnostics& counts = result.diagnostics;

  // Section 1: the smoothed depth image and the point cloud.
  const cv::Mat measured = MeasuredDepth(frame.depth_m);
  const cv::Mat depth =
      FillDepthHoles(RemoveFlyingPixels(measured, frame.intrinsics.fx_px, frame.intrinsics.fy_px,
                                        options.flying_pixels),
                     options.depth_fill);
  InterruptionPoint();
  cv::Mat points = BackProject(depth, frame.intrinsics, options.max_depth_m);
  InterruptionPoint();
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_too_far = CountBeyond(measured, options.max_depth_m);
  counts.num_points = CountMeasured(ChannelZ(points));
  clock.Begin("normals");

  NormalMap normals = EstimateNormals(points, frame.intrinsics, options.normals);
  clock.Begin("color_saliency");

  // Section 3.1: where something stands out, in colour and in depth.
  const cv::Mat color_saliency = StrengthSaliency(frame.color_rgb, options.color_saliency);
  clock.Begin("depth_saliency");
  const cv::Mat depth_saliency = DepthSaliency(depth, options.depth_saliency);
  clock.Begin("seeds");

  // Section 3.2: seeds at salient positions, except on the dominating support surface.
  SalientPositions salient =
      FindSalientPositions(color_saliency, options.color_saliency.downscale, depth_saliency,
                           options.depth_saliency.downscale, points, options.seeds, counts);
  clock.Begin("support");

  // Of wide windows, which noise far away tilts less than every pixel's.
  const NormalMap wide_normals = EstimateNormals(points, frame.intrinsics, options.gravity.normals);
  result.gravity = FindGravity(frame.gravity, wide_normals.vectors, options.gravity);
  const std::vector<Support> supports =
      FindSupports(points, wide_normals, result.gravity.direction, options.support);
  if (!supports.empty()) result.support = supports.front().surface;
  std::vector<Seed> seeds = SeedsAbove(supports, salient.seeds, options.support, salient.removed);
  counts.seeds_on_support = salient.seeds.size() - seeds.size();
  // What cannot be measured leaves a hole in its support.
  const cv::Mat standing = StandInForMissing(depth, supports, frame.intrinsics,
                                             options.support.max_height_m, points, normals);
  clock.Begin("voxels");

  // Section 3: the scene as voxels, labelled by a Markov random field.
  const VoxelGrid grid = BuildVoxelGrid(points, normals, options.voxels);
  std::vector<char> is_background =
      FindBackground(grid, supports, options.support, frame.intrinsics, options.region);
  const std::vector<char> on_wall =
      FindWalls(grid, -result.gravity.direction, supports, options.support, options.walls);
  AddWalls(on_wall, is_background);
  seeds = CoverWithSeeds(grid, is_background, seeds, options.cover);
  clock.Begin("energy");
  const std::vector<MeanColor> colors = ColorsOfVoxels(grid, is_background, frame.color_rgb);
  const PottsEnergy energy = BuildEnergy(grid, points, colors, is_background, seeds, options.mrf);
  counts.num_seeds = seeds.size();
  counts.num_voxels = grid.voxels.size();
  clock.Begin("graph_cut");
  const std::vector<int> labels = LabelVoxels(energy, options.mrf);
  clock.Begin("refinement");

  // Section 3.3: segments that look alike are one object.
  const RefinedScene refined =
      Refine({grid, labels, points, frame.color_rgb, colors, frame.intrinsics,
              -result.gravity.direction, supports, standing, on_wall},
             options);
  counts.num_segments = refined.tree.num_segments;
  counts.num_merged = refined.num_merged;
  counts.segments_implausible = refined.rejected.size();
  result.rejected = refined.rejected;
  clock.Begin("objects");

  result.labels = LabelsWithin(grid, refined.objects, standing | (measured == measured));
  DescribeObjects(frame, points, MeanSaliency(color_saliency, depth_saliency), refined.confidences,
                  supports, options.objects, result);
  counts.messages = ExplainLosses(result);
  clock.Finish();
  if (trace != nullptr) {
    *trace = {depth,
              color_saliency,
              depth_saliency,
              seeds,
              salient.removed,
              options.mrf.data.gamma_per_m2,
              grid,
              colors,
              labels,
              refined.segments,
              LabelsOfChosen(refined.tree, refined.tree.LikelyNodes(), refined.segments),
              refined.tree,
              refined.evidence,
              standing};
  }
}

}  // namespace

Detections Detect(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                  const std::function<bool()>& should_stop) {
  Validate(frame);
  Validate(options);
  RequireNotEmpty(options.paper ? options.paper->region : options.region, frame.depth_m.size());
  Detections result;
  StageClock clock(result.stage_times, should_stop, "depth");
  try {
    if (options.paper) {
      paper::FindObjects(frame, *options.paper, trace, clock, result);
    } else {
      FindObjects(frame, options, trace, clock, result);
    }
  } catch (Cancelled& cancelled) {
    cancelled.stage_times = clock.TimesUntilNow();
    throw;
  }
  return result;
}

}  // namespace fovea
