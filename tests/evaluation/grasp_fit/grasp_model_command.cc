#include "tests/evaluation/grasp_fit/grasp_model_command.h"

#include <cstdint>
#include <memory>
#include <string>

#include "tests/evaluation/grasp_fit/grasp_trials.h"
#include "tests/evaluation/output.h"

namespace fovea::evaluation {
namespace {

struct GraspModelFlags : GeneratedFlags {
  int num_rounds = 2;
  std::string source;
};

// What a model takes for the likeliest is where it errs in its favour, so the next one hears of it.
void Run(const GraspModelFlags& flags) {
  GraspModel model = FittedGraspModel();
  GraspTrials trials;
  GeneratedFlags scenes = flags;
  for (int round = 0; round < flags.num_rounds; ++round) {
    TryGrasps(scenes, model, trials);
    model = FitGraspModel(trials);
    scenes.first_seed += static_cast<std::uint64_t>(flags.num_scenes);
  }
  WriteText(flags.source, ToSource(model));
}

}  // namespace

void AddGraspModelCommand(CLI::App& app) {
  auto flags = std::make_shared<GraspModelFlags>();
  CLI::App* command = app.add_subcommand(
      "grasp-model", "Fit how likely grasps are to succeed to trials in generated scenes");
  AddGeneratedFlags(*command, *flags);
  command
      ->add_option(
          "--rounds", flags->num_rounds,
          "Of as many scenes each, of the next seeds; after each the model is fitted to all "
          "trials so far, and chooses what is tried in the next")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      ->add_option("--source", flags->source,
                   "Write it as source, for core/grasping/fitted_grasp_model.cc")
      ->check(WhyNotWritable);
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
