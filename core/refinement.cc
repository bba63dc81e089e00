#include "core/refinement.h"

#include <utility>

#include "core/objects/rejection.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/segment_graph.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// What is less likely one object is not considered.
constexpr double kMinLogOdds = -6;

MergeTree JoinSegments(const LabelledScene& scene, const std::vector<int>& segments,
                       const DetectorOptions& options) {
  const auto find_separate = [&](const std::vector<int>& objects) {
    return MergeOccluded(scene.grid, objects, scene.points, scene.colors, scene.intrinsics,
                         scene.up, options.occlusion_merge);
  };
  return BuildMergeTree(
      SegmentGraph(scene.grid, segments, scene.colors, scene.intrinsics, scene.up), segments,
      kMinLogOdds, find_separate);
}

}  // namespace

RefinedScene Refine(const LabelledScene& scene, const DetectorOptions& options) {
  RefinedScene result;
  result.segments = SplitIntoSegments(scene.grid, scene.labels);
  RequireFewSegments(result.segments);
  SegmentEvidence seen;
  RunTogether({[&] { result.tree = JoinSegments(scene, result.segments, options); },
               [&] { seen = LookAtSegments(scene, result.segments, options.support); }});
  result.evidence = CollectEvidence(std::move(seen), result.tree);
  InterruptionPoint();
  const std::vector<double> probabilities =
      ObjectProbabilities(result.tree, options.object_model->LogWeights(result.evidence));
  InterruptionPoint();
  const std::vector<int> chosen = ChooseObjects(result.tree, probabilities, options.choice);
  result.objects = LabelsOfChosen(result.tree, chosen, result.segments);
  for (const int node : chosen) {
    result.confidences.push_back(static_cast<float>(probabilities[node]));
    result.num_merged += result.evidence[node].num_segments - 1;
  }
  InterruptionPoint();
  result.rejected =
      FindRejected(result.tree, chosen, result.evidence, probabilities, *options.object_model);
  return result;
}

}  // namespace fovea
