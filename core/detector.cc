#include "core/detector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "core/depth/back_projection.h"
#include "core/explanation.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/segmentation/labels.h"
#include "core/stage_clock.h"

namespace fovea {
namespace {

std::size_t CountMeasured(const cv::Mat& depth) {
  return static_cast<std::size_t>(cv::countNonZero(depth == depth));  // false for NaN
}

cv::Mat ChannelZ(const cv::Mat& points) {
  cv::Mat z;
  cv::extractChannel(points, z, 2);
  return z;
}

// Depth that the stages can rely on: every value that is not a positive number is NaN.
cv::Mat CleanDepth(const cv::Mat& depth_m) {
  cv::Mat clean = depth_m.clone();
  for (auto it = clean.begin<float>(); it != clean.end<float>(); ++it) {
    if (!std::isfinite(*it) || *it <= 0) *it = std::numeric_limits<float>::quiet_NaN();
  }
  return clean;
}

Gravity FindGravity(const RgbdFrame& frame, const cv::Mat& points, const GravityOptions& options) {
  if (frame.gravity) return {frame.gravity->normalized(), Gravity::Source::kGiven};
  const NormalOptions wide{.window_radius_px = options.window_radius_px};
  const cv::Mat normals = EstimateNormals(points, frame.intrinsics, wide, options.step_px);
  return {EstimateGravity(normals, options), Gravity::Source::kEstimated};
}

// The paper removes seeds on the support surface; what lies below it cannot stand on it either.
std::vector<Seed> SeedsAboveSupport(const std::vector<Seed>& seeds,
                                    const std::optional<SupportSurface>& support,
                                    const SupportOptions& options) {
  if (!support) return seeds;
  std::vector<Seed> above;
  for (const Seed& seed : seeds) {
    if (support->HeightOf(seed.position) > SupportTolerance(seed.position.z(), options)) {
      above.push_back(seed);
    }
  }
  return above;
}

std::vector<char> VoxelsOnSupport(const VoxelGrid& grid,
                                  const std::optional<SupportSurface>& support,
                                  const SupportOptions& options) {
  std::vector<char> on_support(grid.voxels.size(), 0);
  if (!support) return on_support;
  for (std::size_t v = 0; v < grid.voxels.size(); ++v) {
    const Eigen::Vector3f& mean = grid.voxels[v].mean;
    on_support[v] = support->HeightOf(mean) <= SupportTolerance(mean.z(), options);
  }
  return on_support;
}

// Labels of the pixels, only where the sensor measured depth: filled holes help to segment, but
// nobody has seen what is there.
cv::Mat LabelsOfPixels(const VoxelGrid& grid, const std::vector<int>& labels,
                       const cv::Mat& measured_depth) {
  cv::Mat image = cv::Mat::zeros(measured_depth.size(), CV_16UC1);
  for (int row = 0; row < image.rows; ++row) {
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const float* depth = measured_depth.ptr<float>(row);
    auto* label = image.ptr<std::uint16_t>(row);
    for (int col = 0; col < image.cols; ++col) {
      if (voxel[col] < 0 || std::isnan(depth[col])) continue;
      label[col] = static_cast<std::uint16_t>(labels[voxel[col]]);
    }
  }
  return image;
}

}  // namespace

Detections Detect(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                  const std::function<bool()>& should_stop) {
  Validate(frame);
  Validate(options);
  Detections result;
  Diagnostics& counts = result.diagnostics;
  StageClock clock(result.stage_times, should_stop);

  // Section 1: the smoothed depth image and the point cloud.
  const cv::Mat measured = CleanDepth(frame.depth_m);
  const cv::Mat depth = FillDepthHoles(measured, options.depth_fill);
  const cv::Mat points = BackProject(depth, frame.intrinsics, options.max_depth_m);
  counts.num_pixels = measured.total();
  counts.num_measured = CountMeasured(measured);
  counts.num_points = CountMeasured(ChannelZ(points));
  clock.Finish("depth");

  const cv::Mat normals = EstimateNormals(points, frame.intrinsics, options.normals);
  clock.Finish("normals");

  // Section 3.1: where something stands out, in colour and in depth.
  const cv::Mat color_saliency = StrengthSaliency(frame.color_rgb, options.color_saliency);
  clock.Finish("color_saliency");
  const cv::Mat depth_saliency = DepthSaliency(depth, options.depth_saliency);
  clock.Finish("depth_saliency");

  // Section 3.2: seeds at salient positions, except on the dominating support surface.
  const SeedCandidates from_color =
      FindSeeds(color_saliency, points, Seed::Source::kColorSaliency, options.seeds);
  const SeedCandidates from_depth =
      FindSeeds(depth_saliency, points, Seed::Source::kDepthSaliency, options.seeds);
  counts.seeds_from_color = from_color.seeds.size() + from_color.without_depth;
  counts.seeds_from_depth = from_depth.seeds.size() + from_depth.without_depth;
  counts.seeds_without_depth = from_color.without_depth + from_depth.without_depth;
  clock.Finish("seeds");

  result.gravity = FindGravity(frame, points, options.gravity);
  result.support = FindSupportSurface(points, normals, result.gravity.direction, options.support);
  std::vector<Seed> seeds = from_color.seeds;
  seeds.insert(seeds.end(), from_depth.seeds.begin(), from_depth.seeds.end());
  const std::size_t num_candidates = seeds.size();
  seeds = SeedsAboveSupport(seeds, result.support, options.support);
  counts.seeds_on_support = num_candidates - seeds.size();
  clock.Finish("support");

  // Section 3: the scene as voxels, labelled by a Markov random field.
  const VoxelGrid grid = BuildVoxelGrid(points, normals, options.voxels);
  const PottsEnergy energy = BuildEnergy(
      grid, points, VoxelsOnSupport(grid, result.support, options.support), seeds, options.mrf);
  counts.num_seeds = seeds.size();
  counts.num_voxels = grid.voxels.size();
  clock.Finish("energy");
  const std::vector<int> labels = MinimizeByAlphaExpansion(energy, options.mrf.max_sweeps);
  clock.Finish("graph_cut");

  // Section 3.3: touching segments that look alike are one object.
  const std::vector<int> segments = SplitIntoSegments(grid, labels);
  const std::vector<int> objects =
      MergeByShape(grid, MergeByColor(grid, segments, frame.color_rgb, options.color_merge),
                   frame.color_rgb, options.shape_merge);
  counts.num_segments = CountLabels(segments);
  counts.num_merged = counts.num_segments - CountLabels(objects);
  clock.Finish("refinement");

  result.labels = LabelsOfPixels(grid, objects, measured);
  DescribeObjects(frame, points, options.objects, result);
  counts.messages = ExplainLosses(result);
  clock.Finish("objects");
  if (trace != nullptr) *trace = {color_saliency, depth_saliency, seeds};
  return result;
}

}  // namespace fovea
