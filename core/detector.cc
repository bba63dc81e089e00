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
#include "core/scene_geometry.h"
#include "core/seeds/salient_positions.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/contraction.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/mean_color.h"
#include "core/stage_clock.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

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

struct Salience {
  cv::Mat color, depth;  // CV_32FC1, frame size
  SalientPositions positions;
};

// Section 3.1: where something stands out, in colour and in depth, and 3.2: which positions that
// gives. The first stage of `clock`, "color_saliency", has begun.
Salience FindSalience(const RgbdFrame& frame, const cv::Mat& depth, const cv::Mat& points,
                      const DetectorOptions& options, StageClock& clock, Diagnostics& counts) {
  Salience salience;
  salience.color = StrengthSaliency(frame.color_rgb, options.color_saliency);
  clock.Begin("depth_saliency");
  salience.depth = DepthSaliency(depth, options.depth_saliency);
  clock.Begin("seeds");
  salience.positions =
      FindSalientPositions(salience.color, options.color_saliency.downscale, salience.depth,
                           options.depth_saliency.downscale, points, options.seeds, counts);
  return salience;
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
  const cv::Mat measured_points = BackProject(depth, frame.intrinsics, options.max_depth_m);
  InterruptionPoint();
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_too_far = CountBeyond(measured, options.max_depth_m);
  counts.num_points = CountMeasured(ChannelZ(measured_points));

  // What the scene consists of, and where something in it stands out: neither needs the other.
  SceneGeometry scene;
  Salience salience;
  const auto find_geometry = [&](StageClock& own) {
    scene = FindGeometry(frame, depth, measured_points, options, own);
  };
  const auto find_salience = [&](StageClock& own) {
    salience = FindSalience(frame, depth, measured_points, options, own, counts);
  };
  clock.RunBranches({{"normals", find_geometry}, {"color_saliency", find_salience}});
  result.gravity = scene.gravity;
  if (!scene.supports.empty()) result.support = scene.supports.front().surface;
  clock.Begin("energy");

  // Section 3: seeds above the supports, and the scene as voxels, labelled by a Markov random
  // field.
  SalientPositions& salient = salience.positions;
  const std::vector<Seed> above =
      SeedsAbove(scene.supports, salient.seeds, options.support, salient.removed);
  counts.seeds_on_support = salient.seeds.size() - above.size();
  std::vector<Seed> seeds;
  std::vector<MeanColor> colors;
  RunTogether(
      {[&] { seeds = CoverWithSeeds(scene.grid, scene.is_background, above, options.cover); },
       [&] { colors = ColorsOfVoxels(scene.grid, scene.is_background, frame.color_rgb); }});
  const PottsEnergy energy =
      BuildEnergy(scene.grid, scene.points, colors, scene.is_background, seeds, options.mrf);
  counts.num_seeds = seeds.size();
  counts.num_voxels = scene.grid.voxels.size();
  clock.Begin("graph_cut");
  const std::vector<int> labels = LabelVoxels(energy, options.mrf);
  clock.Begin("refinement");

  // Section 3.3: segments that look alike are one object.
  const RefinedScene refined =
      Refine({scene.grid, labels, scene.points, frame.color_rgb, colors, frame.intrinsics,
              -scene.gravity.direction, scene.supports, scene.standing, scene.on_wall},
             options);
  counts.num_segments = refined.tree.num_segments;
  counts.num_merged = refined.num_merged;
  counts.segments_implausible = refined.rejected.size();
  result.rejected = refined.rejected;
  clock.Begin("objects");

  result.labels =
      LabelsWithin(scene.grid, refined.objects, scene.standing | (measured == measured));
  DescribeObjects(frame, scene.points, MeanSaliency(salience.color, salience.depth),
                  refined.confidences, scene.supports, options.objects, result);
  counts.messages = ExplainLosses(result);
  clock.Finish();
  if (trace != nullptr) {
    *trace = {depth,
              salience.color,
              salience.depth,
              seeds,
              salient.removed,
              options.mrf.data.gamma_per_m2,
              scene.grid,
              colors,
              labels,
              refined.segments,
              LabelsOfChosen(refined.tree, refined.tree.LikelyNodes(), refined.segments),
              refined.tree,
              refined.evidence,
              scene.standing};
  }
}

}  // namespace

Detections Detect(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                  const std::function<bool()>& should_stop) {
  Validate(frame);
  Validate(options);
  RequireNotEmpty(options.paper ? options.paper->region : options.region, frame.depth_m.size());
  Detections result;
  const InterruptionScope interruption(should_stop);
  StageClock clock("depth");
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
  result.stage_times = clock.TimesUntilNow();
  return result;
}

}  // namespace fovea
