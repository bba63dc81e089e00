#include "core/search.h"

#include <algorithm>
#include <utility>

#include "core/depth/back_projection.h"
#include "core/objects/portions.h"
#include "core/objects/rejection.h"
#include "core/saliency/mean_saliency.h"
#include "core/segmentation/alpha_expansion.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Where no support is found all that is seen may be an object: in larger pieces.
CoverOptions CoverOf(const SceneGeometry& scene, CoverOptions options) {
  constexpr double kWider = 1.5;
  if (scene.supports.empty()) options.spacing_m *= kWider;
  return options;
}

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

void Add(std::vector<int> labels_of_part, RefinedScene part, FoundObjects& found) {
  const int num_before = static_cast<int>(found.confidences.size());
  for (std::size_t v = 0; v < found.objects.size(); ++v) {
    if (part.objects[v] > 0) found.objects[v] = num_before + part.objects[v];
  }
  found.confidences.insert(found.confidences.end(), part.confidences.begin(),
                           part.confidences.end());
  found.rejected.insert(found.rejected.end(), part.rejected.begin(), part.rejected.end());
  found.num_segments += part.tree.num_segments;
  found.num_merged += part.num_merged;
  found.labels = std::move(labels_of_part);
  found.segments = std::move(part.segments);
  found.tree = std::move(part.tree);
  found.evidence = std::move(part.evidence);
}

}  // namespace

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
  search.seeds = CoverWithSeeds(scene.grid, scene.is_background, search.salient.seeds,
                                CoverOf(scene, options.cover));
  counts.num_seeds = search.seeds.size();
  counts.num_voxels = scene.grid.voxels.size();
  // As if all were background, until something has been looked at.
  for (std::vector<int>* of_voxels :
       {&search.found.objects, &search.found.labels, &search.found.segments}) {
    of_voxels->resize(scene.grid.voxels.size(), 0);
  }
  const auto look_at = [&](const std::vector<char>& is_background) {
    clock.Begin("energy");
    const auto [energy, clusters] =
        BuildEnergy(scene.grid, scene.colors, is_background, search.seeds, options.mrf);
    clock.Begin("graph_cut");
    // In one sweep, which does nearly all that more would.
    const std::vector<int> labels = LabelsOfNodes(clusters, MinimizeByAlphaExpansion(energy, 1));
    clock.Begin("refinement");
    // Section 3.3: segments that look alike are one object.
    Add(labels,
        Refine(
            {scene.grid, labels, scene.points, scene.lab, scene.colors, frame.intrinsics,
             -scene.gravity.direction, scene.supports, scene.standing, scene.on_wall, frame.unseen},
            options),
        search.found);
  };
  search.saliency = MeanSaliency(search.salience.color, search.salience.depth);
  for (const std::vector<char>& outside : PortionsInTime(scene, search.saliency, budget)) {
    if (result.incomplete) break;
    result.incomplete = !budget.Suffices([&] { look_at(outside); });
  }
  budget.Lift();
  counts.num_segments = search.found.num_segments;
  counts.num_merged = search.found.num_merged;
  counts.segments_implausible = search.found.rejected.size();
  KeepLikeliest(search.found.rejected);
  return search;
}

}  // namespace fovea
