#include "tests/evaluation/grasp_fit/grasp_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "tests/evaluation/generated/generated_run.h"
#include "tests/evaluation/grasp_check/check_grasp.h"
#include "tests/evaluation/grasp_check/physical_scene.h"
#include "tests/evaluation/grasp_figures/grasp_run.h"
#include "tests/evaluation/logistic_regression.h"
#include "tests/evaluation/term_columns.h"

namespace fovea::evaluation {
namespace {

constexpr std::size_t kSpread = 10, kLikeliest = 10;

// Of the candidates of one gripper.
std::vector<const ScoredGrasp*> Chosen(const std::vector<ScoredGrasp>& candidates,
                                       std::size_t gripper, const GraspModel& model) {
  std::vector<const ScoredGrasp*> own, chosen;
  for (const ScoredGrasp& candidate : candidates) {
    if (candidate.grasp.gripper == gripper) own.push_back(&candidate);
  }
  const std::size_t step = own.size() / kSpread + 1;
  for (std::size_t i = 0; i < own.size(); i += step) chosen.push_back(own[i]);
  std::stable_sort(own.begin(), own.end(), [&](const auto* a, const auto* b) {
    return model.Probability(*a) > model.Probability(*b);
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
        for (const ScoredGrasp* grasp : chosen) {
          const Outcome outcome = CheckGrasp(physical, body, grippers[g], grasp->grasp);
          trials[static_cast<std::size_t>(grasp->family)].push_back(
              {grasp->terms, 1.0 / static_cast<double>(chosen.size()),
               outcome == Outcome::kSuccess});
        }
      }
    }
  }
}

// With knots where the term's values are, and what the slopes are multiplied by in each trial.
GraspFunction FitFamily(const std::vector<GraspTrial>& trials, std::size_t family) {
  // Of cups there are fewer trials: chosen where the figures of other seeds are best.
  const bool is_suction = family == static_cast<std::size_t>(GraspFamily::kSuction);
  const double penalty = is_suction ? 1e-2 : 1e-3;
  const auto count = static_cast<Eigen::Index>(trials.size());
  GraspFunction function;
  for (std::size_t t = 0; t < kNumGraspTerms; ++t) {
    std::vector<double> values;
    for (const GraspTrial& trial : trials) values.push_back(static_cast<double>(trial.terms[t]));
    function.functions[t] = WithKnotsAt(std::move(values));
  }
  Eigen::MatrixXd rows(count, static_cast<Eigen::Index>(kNumGraspTerms) * kColumnsOfTerm);
  Eigen::VectorXd succeeds(count), weights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const GraspTrial& trial = trials[static_cast<std::size_t>(i)];
    for (std::size_t t = 0; t < kNumGraspTerms; ++t) {
      rows.block<1, kColumnsOfTerm>(i, static_cast<Eigen::Index>(t) * kColumnsOfTerm) =
          ColumnsOf(function.functions[t], static_cast<double>(trial.terms[t]));
    }
    succeeds[i] = trial.succeeds ? 1 : 0;
    weights[i] = trial.weight;
  }
  const LogisticModel fitted = FitLogistic(rows, succeeds, weights, penalty);
  fmt::print("family {}: {} trials, {:.1f} % succeed, log loss {:.3f}\n", family, count,
             100 * succeeds.dot(weights) / weights.sum(),
             LogLoss(fitted.LogOdds(rows), succeeds, weights));
  function.bias = fitted.bias;
  for (std::size_t t = 0; t < kNumGraspTerms; ++t) {
    for (std::size_t k = 0; k < TermFunction::kNumKnots + 1; ++k) {
      function.functions[t].slopes[k] =
          fitted.weights[static_cast<Eigen::Index>(t * kColumnsOfTerm + k)];
    }
  }
  return function;
}

}  // namespace

GraspTrials TryGrasps(const GeneratedFlags& flags, const GraspModel& model) {
  DetectorOptions options = OptionsOf(flags);
  options.grippers = EvaluationGrippers();
  std::vector<GraspTrials> of_scenes(NumScenes(flags));
  ForEachGeneratedScene(flags, options, [&](std::size_t i, const GeneratedScene& scene) {
    TryIn(scene, options.grippers, model, of_scenes[i]);
  });
  GraspTrials all;
  for (GraspTrials& trials : of_scenes) {
    for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
      std::move(trials[f].begin(), trials[f].end(), std::back_inserter(all[f]));
    }
  }
  return all;
}

GraspModel FitGraspModel(const GraspTrials& trials) {
  GraspModel model;
  for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
    if (!trials[f].empty()) model.families[f] = FitFamily(trials[f], f);
  }
  return model;
}

std::string ToSource(const GraspModel& model) {
  constexpr std::array<const char*, kNumGraspFamilies> kNames = {"across", "rim", "handle",
                                                                 "suction"};
  std::string text =
      "// Made by `fovea-eval grasp-model`; see docs/quality.md.\n"
      "#include \"core/grasping/grasp_model.h\"\n\nnamespace fovea {\n\n"
      "const GraspModel& FittedGraspModel() {\n"
      "  constexpr double kNone = TermFunction::kNoKnot;\n"
      "  // A line a term, in the order of grasp_terms.h.\n"
      "  // clang-format off\n"
      "  static const GraspModel model = {{{\n";
  for (std::size_t f = 0; f < kNumGraspFamilies; ++f) {
    const GraspFunction& function = model.families[f];
    text += fmt::format("      {{{:.5g}, {{{{  // {}\n", function.bias, kNames[f]);
    for (const TermFunction& of_term : function.functions) {
      text += fmt::format("          {},\n", SourceOf(of_term));
    }
    text += "      }}},\n";
  }
  return text + "  }}};\n  // clang-format on\n  return model;\n}\n\n}  // namespace fovea\n";
}

}  // namespace fovea::evaluation
