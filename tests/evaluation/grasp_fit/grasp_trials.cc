#include "tests/evaluation/grasp_fit/grasp_trials.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "tests/evaluation/generated/generated_run.h"
#include "tests/evaluation/grasp_check/check_grasp.h"
#include "tests/evaluation/grasp_check/physical_scene.h"
#include "tests/evaluation/grasp_figures/grasp_run.h"

namespace fovea::evaluation {
namespace {

constexpr std::array<const char*, kNumGraspFamilies> kFamilies = {"across", "rim", "handle",
                                                                  "suction"};
constexpr std::size_t kSpread = 20, kLikeliest = 20;

// Of the candidates of one gripper.
std::vector<ScoredGrasp> Chosen(const std::vector<ScoredGrasp>& candidates, std::size_t gripper,
                                const GraspModel& model) {
  std::vector<ScoredGrasp> own, chosen;
  for (const ScoredGrasp& candidate : candidates) {
    if (candidate.grasp.gripper == gripper) own.push_back(candidate);
  }
  model.SetProbabilities(own);
  const std::size_t step = own.size() / kSpread + 1;
  for (std::size_t i = 0; i < own.size(); i += step) chosen.push_back(own[i]);
  std::stable_sort(own.begin(), own.end(), [](const ScoredGrasp& a, const ScoredGrasp& b) {
    return a.grasp.probability > b.grasp.probability;
  });
  own.resize(std::min(own.size(), kLikeliest));
  chosen.insert(chosen.end(), own.begin(), own.end());
  return chosen;
}

void TryIn(const GeneratedScene& scene, const std::vector<Gripper>& grippers,
           const GraspModel& model, GraspTrials& trials) {
  const PhysicalScene physical(scene.scene);
  for (const GeneratedFrame& frame : scene.frames) {
    for (const MatchedObject& match : frame.matches) {
      const int body = physical.BodyOf(frame.labelled.objects[match.truth].label);
      for (std::size_t g = 0; g < grippers.size(); ++g) {
        const auto chosen = Chosen(frame.grasp_candidates[match.answer], g, model);
        for (const ScoredGrasp& grasp : chosen) {
          const Outcome outcome = CheckGrasp(physical, body, grippers[g], grasp.grasp);
          trials[static_cast<std::size_t>(grasp.family)].push_back(
              {grasp.terms, 1.0 / static_cast<double>(chosen.size()),
               outcome == Outcome::kSuccess});
        }
      }
    }
  }
}

}  // namespace

void TryGrasps(const GeneratedFlags& flags, const GraspModel& model, GraspTrials& trials) {
  DetectorOptions options = OptionsOf(flags);
  options.grippers = EvaluationGrippers();
  std::vector<GraspTrials> of_scenes(NumScenes(flags));
  ForEachGeneratedScene(flags, options, [&](std::size_t i, const GeneratedScene& scene) {
    TryIn(scene, options.grippers, model, of_scenes[i]);
  });
  for (GraspTrials& of_scene : of_scenes) {
    for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
      std::move(of_scene[f].begin(), of_scene[f].end(), std::back_inserter(trials[f]));
    }
  }
}

GraspModel FitGraspModel(const GraspTrials& trials) {
  GraspModel model;
  for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
    model.families[f] = Boost(trials[f]);
    fmt::print("{}: {} trials, log loss {:.3f}\n", kFamilies[f], trials[f].size(),
               LogLoss(model.families[f], trials[f]));
  }
  return model;
}

std::string ToSource(const GraspModel& model) {
  std::string text =
      "// Made by `fovea-eval grasp-model`; see docs/fitted_models.md.\n"
      "#include \"core/grasping/grasp_model.h\"\n\nnamespace fovea {\n\n"
      "const GraspModel& FittedGraspModel() {\n"
      "  // A line a tree: which terms it asks, in the order of grasp_terms.h, and for what.\n"
      "  // clang-format off\n"
      "  static const GraspModel model = {{{\n";
  for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
    text += fmt::format("      {{{}, {{  // {}\n", model.families[f].bias, kFamilies[f]);
    for (const GraspTree& tree : model.families[f].trees) {
      text +=
          fmt::format("          {{{{{}}}, {{{:.9g}}}, {{{}}}}},\n", fmt::join(tree.terms, ", "),
                      fmt::join(tree.thresholds, ", "), fmt::join(tree.values, ", "));
    }
    text += "      }},\n";
  }
  return text + "  }}};\n  // clang-format on\n  return model;\n}\n\n}  // namespace fovea";
}

}  // namespace fovea::evaluation
