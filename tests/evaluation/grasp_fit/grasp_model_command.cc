#include "tests/evaluation/grasp_fit/grasp_model_command.h"

#include <memory>
#include <string>

#include "tests/evaluation/grasp_fit/grasp_trials.h"
#include "tests/evaluation/output.h"

namespace fovea::evaluation {
namespace {

struct Flags : GeneratedFlags {
  std::string source;
};

void Run(const Flags& flags) {
  WriteText(flags.source, ToSource(FitGraspModel(TryGrasps(flags, FittedGraspModel()))));
}

}  // namespace

void AddGraspModelCommand(CLI::App& app) {
  auto flags = std::make_shared<Flags>();
  CLI::App* command = app.add_subcommand(
      "grasp-model", "Fit how likely grasps are to succeed to trials in generated scenes");
  AddGeneratedFlags(*command, *flags);
  command->add_option("--source", flags->source,
                      "Write it as source, for core/grasping/fitted_grasp_model.cc");
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
