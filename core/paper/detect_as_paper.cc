#include "core/paper/detect_as_paper.h"

#include <optional>

#include "core/depth/back_projection.h"
#include "core/depth/measured_depth.h"
#include "core/paper/confidence.h"
#include "core/paper/superpixel_contrast.h"
#include "core/paper/support_reading.h"
#include "core/saliency/mean_saliency.h"
#include "core/scene/background.h"
#include "core/seeds/salient_positions.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/labels.h"

namespace fovea::paper {

ObjectSurroundings FindObjects(const RgbdFrame& frame, const PaperOptions& options, Trace* trace,
                               StageClock& clock, Detections& result) {
  Diagnostics& counts = result.diagnostics;

  // Section 1: the smoothed depth image and the point cloud.
  const cv::Mat& measured = frame.depth_m;
  const cv::Mat depth = FillDepthHoles(measured, options.depth_fill);
  const cv::Mat points = BackProject(depth, frame.intrinsics, options.max_depth_m);
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_too_far = counts.num_measured - CountUpTo(measured, options.max_depth_m);
  counts.num_points = CountMeasured(ChannelZ(points));

  // Section 3.1: where something stands out, in colour and in depth. Neither needs the other, nor
  // normals.
  NormalMap normals;
  cv::Mat color_saliency, depth_saliency;
  const auto find_normals = [&](StageClock& /*own*/) {
    normals = EstimateNormals(points, frame.intrinsics, options.normals);
  };
  const auto find_color_saliency = [&](StageClock& /*own*/) {
    color_saliency = StrengthSaliency(frame.color_rgb, options.color_saliency);
  };
  const auto find_depth_saliency = [&](StageClock& /*own*/) {
    depth_saliency = DepthSaliency(depth, options.depth_saliency,
                                   ContrastOfSuperpixels(options.superpixels_per_diagonal));
  };
  clock.RunBranches({{"normals", find_normals},
                     {"color_saliency", find_color_saliency},
                     {"depth_saliency", find_depth_saliency}});

  // Section 3.2: seeds at salient positions, except on the dominating support surface.
  clock.Begin("seeds");
  SalientPositions salient =
      FindSalientPositions(color_saliency, options.color_saliency.downscale, depth_saliency,
                           options.depth_saliency.downscale, points, options.seeds, counts);
  if (!options.fixations.empty()) salient = SeedsAt(options.fixations, points);
  clock.Begin("support");
  NormalMap wide_normals;
  if (!frame.gravity) {
    wide_normals = EstimateNormals(points, frame.intrinsics, options.gravity.normals);
  }
  result.gravity = FindGravity(frame.gravity, wide_normals.vectors, options.gravity);
  const std::vector<Support> supports =
      FindSupports(points, normals, result.gravity.direction, options.support);
  if (!supports.empty()) result.support = supports.front().surface;
  const std::vector<Seed> seeds =
      SeedsOffSupport(result.support, salient.seeds, options, salient.removed);
  counts.seeds_on_support = salient.seeds.size() - seeds.size();
  counts.num_seeds = seeds.size();

  // Section 3: the scene as voxels, labelled by a Markov random field.
  clock.Begin("voxels");
  const VoxelGrid grid = BuildVoxelGrid(points, normals, options.voxels);
  counts.num_voxels = grid.voxels.size();
  clock.Begin("energy");
  const PottsEnergy energy =
      BuildSurfaceEnergy(grid, points, CertainBackground(grid, supports, frame.intrinsics, options),
                         PointsOfSupport(points, result.support, options), seeds, options.mrf);
  clock.Begin("graph_cut");
  const std::vector<int> labels = MinimizeByAlphaExpansion(energy, options.mrf.max_sweeps);

  // Section 3.3: segments that touch and look alike are one object.
  clock.Begin("refinement");
  const std::vector<int> segments = SegmentsOf(grid, labels, options.color_merge);
  const std::vector<int> objects =
      MergeByColor(grid, segments, frame.color_rgb, options.color_merge);
  counts.num_segments = CountLabels(segments);
  counts.num_merged = counts.num_segments - CountLabels(objects);

  // Section 4: what is reported of them.
  clock.Begin("objects");
  result.labels = LabelsWithin(grid, objects, measured == measured);
  const std::vector<float> confidences = Confidences(result.labels, measured, frame.intrinsics);
  const std::vector<char> hidden =
      FindHiddenByRegion(grid, supports, options.support, frame.intrinsics, options.region);
  DescribeObjects(frame, {ChannelZ(points), frame.intrinsics},
                  {MeanSaliency(color_saliency, depth_saliency)},
                  {confidences, FindCutByRegion(grid, objects, CountLabels(objects), hidden)},
                  supports, options.objects, result);
  clock.Finish();
  if (trace != nullptr) {
    *trace = {
        .depth_m = depth,
        .color_saliency = color_saliency,
        .depth_saliency = depth_saliency,
        .seeds = seeds,
        .removed = salient.removed,
        .gamma_per_m2 = options.mrf.data.gamma_per_m2,
        .voxels = grid,
        .colors = {},
        .labels = labels,
        .segments = segments,
        .merged = objects,
        .tree = {},
        .evidence = {},
        .standing = {},
        .grasp_candidates = {},
    };
  }
  return {points, supports, measured};
}

}  // namespace fovea::paper
