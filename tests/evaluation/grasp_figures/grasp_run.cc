#include "tests/evaluation/grasp_figures/grasp_run.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "tests/evaluation/generated/generated_run.h"
#include "tests/evaluation/grasp_check/check_grasp.h"
#include "tests/evaluation/grasp_check/grasp_search.h"
#include "tests/evaluation/grasp_check/physical_scene.h"
#include "tests/evaluation/grasp_figures/overlay_files.h"

namespace fovea::evaluation {
namespace {

// The search finds the same for every sensor.
class Possible {
 public:
  Possible(const PhysicalScene& scene, const std::vector<Gripper>& grippers)
      : scene_(scene), grippers_(grippers) {}

  bool Of(int body, std::size_t gripper) {
    const auto [known, is_new] = known_.try_emplace({body, gripper}, false);
    if (is_new) known->second = IsPossible(scene_, body, grippers_[gripper]);
    return known->second;
  }

 private:
  const PhysicalScene& scene_;
  const std::vector<Gripper>& grippers_;
  std::map<std::pair<int, std::size_t>, bool> known_;
};

std::vector<GripperResult> Check(const PhysicalScene& scene, int body,
                                 const std::vector<Gripper>& grippers,
                                 const DetectedObject& answer) {
  std::vector<GripperResult> results(grippers.size());
  for (const Grasp& grasp : answer.grasps) {
    GripperResult& result = results.at(grasp.gripper);
    result.outcomes.push_back(CheckGrasp(scene, body, grippers[grasp.gripper], grasp));
    result.unseen_ways.push_back(double{grasp.unseen_way});
    result.probabilities.push_back(std::clamp(double{grasp.probability}, 0.0, 1.0));
  }
  for (const NoGrasp& none : answer.no_grasps) {
    results.at(none.gripper).reason = static_cast<int>(none.reason);
  }
  return results;
}

void CheckCandidates(const PhysicalScene& scene, int body, const std::vector<Gripper>& grippers,
                     std::vector<ScoredGrasp> candidates, std::vector<GripperResult>& results) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.grasp.probability > b.grasp.probability;
  });
  for (const ScoredGrasp& candidate : candidates) {
    const Grasp& grasp = candidate.grasp;
    GripperResult& result = results.at(grasp.gripper);
    result.candidate_outcomes.push_back(CheckGrasp(scene, body, grippers[grasp.gripper], grasp));
    result.candidate_probabilities.push_back(double{grasp.probability});
  }
}

GraspRun CheckScene(const GeneratedScene& scene, const std::vector<Gripper>& grippers,
                    const GraspQuestions& questions) {
  const PhysicalScene physical(scene.scene);
  Possible possible(physical, grippers);
  GraspRun run;
  for (const GeneratedFrame& frame : scene.frames) {
    for (const StageTime& time : frame.detections.stage_times) {
      if (time.stage != "grasps") continue;
      run.num_objects.push_back(static_cast<double>(frame.detections.objects.size()));
      run.grasps_ms.push_back(time.duration_ms);
    }
    for (const scenes::ObjectTruth& truth : frame.labelled.objects) {
      run.num_truth += truth.num_pixels > 0;
    }
    for (const MatchedObject& match : frame.matches) {
      const scenes::ObjectTruth& truth = frame.labelled.objects[match.truth];
      const int body = physical.BodyOf(truth.label);
      GraspedObject object = {
          scene.kind,
          frame.sensor,
          truth.name,
          match.what,
          scene.seed,
          match.visible_share,
          Check(physical, body, grippers, frame.detections.objects[match.answer])};
      if (questions.candidates) {
        CheckCandidates(physical, body, grippers, frame.grasp_candidates[match.answer],
                        object.grippers);
      }
      for (std::size_t g = 0; questions.possible && g < grippers.size(); ++g) {
        object.grippers[g].possible = possible.Of(body, g);
      }
      run.objects.push_back(std::move(object));
    }
  }
  return run;
}

}  // namespace

bool GripperResult::AnySucceeds(std::size_t most) const {
  const auto end = outcomes.begin() + static_cast<long>(std::min(most, outcomes.size()));
  return std::find(outcomes.begin(), end, Outcome::kSuccess) != end;
}

std::vector<Gripper> EvaluationGrippers() {
  Gripper narrow, wide, cup;
  narrow.name = "jaw 85 mm";
  narrow.hand = JawGripper{};
  JawGripper opens_wide;
  opens_wide.max_opening_m = 0.14F;
  wide.name = "jaw 140 mm";
  wide.hand = opens_wide;
  cup.name = "suction 30 mm";
  cup.hand = SuctionGripper{};
  cup.max_tilt_rad = 0.8F;
  return {narrow, wide, cup};
}

GraspRun RunGrasps(const GeneratedFlags& flags, const GraspQuestions& questions) {
  DetectorOptions options = OptionsOf(flags);
  options.grippers = EvaluationGrippers();
  for (Gripper& gripper : options.grippers) gripper.min_probability = questions.min_probability;
  if (!flags.overlays.empty()) std::filesystem::create_directories(flags.overlays);
  std::vector<GraspRun> runs(NumScenes(flags));
  ForEachGeneratedScene(flags, options, [&](std::size_t i, const GeneratedScene& scene) {
    runs[i] = CheckScene(scene, options.grippers, questions);
    if (!flags.overlays.empty()) WriteOverlays(flags.overlays, scene, options.grippers);
  });
  GraspRun all;
  for (GraspRun& run : runs) {
    std::move(run.objects.begin(), run.objects.end(), std::back_inserter(all.objects));
    all.num_truth += run.num_truth;
    all.num_objects.insert(all.num_objects.end(), run.num_objects.begin(), run.num_objects.end());
    all.grasps_ms.insert(all.grasps_ms.end(), run.grasps_ms.begin(), run.grasps_ms.end());
  }
  return all;
}

}  // namespace fovea::evaluation
