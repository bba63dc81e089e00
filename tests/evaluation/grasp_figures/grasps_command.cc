#include "tests/evaluation/grasp_figures/grasps_command.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/evaluation/grasp_figures/grasp_export.h"
#include "tests/evaluation/grasp_figures/grasp_report.h"
#include "tests/evaluation/output.h"

namespace fovea::evaluation {
namespace {

struct GraspsFlags : GeneratedFlags {
  GraspQuestions questions;
};

void Run(const GraspsFlags& flags) {
  const GraspRun run = RunGrasps(flags, flags.questions);
  PrintGrasps(std::cout, run);
  WriteJson(flags.json, ToJson(run));
  if (flags.plot.empty()) return;
  if (run.objects.empty()) throw std::runtime_error("--plot: no object was found");
  WriteText(flags.plot, DrawSvg(GraspCharts(run)));
}

}  // namespace

void AddGraspsCommand(CLI::App& app) {
  auto flags = std::make_shared<GraspsFlags>();
  CLI::App* command = app.add_subcommand(
      "grasps", "Check the grasps of generated scenes against the true solids in them");
  AddGeneratedFlags(*command, *flags);
  AddFigureFlags(*command, *flags);
  command->add_flag("--possible", flags->questions.possible,
                    "Also search whether there is a grasp from above at all: slow");
  command->add_flag("--candidates", flags->questions.candidates,
                    "Also check every grasp that was judged: tells where grasps are lost");
  command
      ->add_option("--min-probability", flags->questions.min_probability,
                   "Of grasps that are offered: less for who tries several")
      ->check(CLI::Range(0.0F, 1.0F))
      ->capture_default_str();
  command->add_option("--overlays", flags->overlays,
                      "Write pictures of the first grasps to this folder: green succeeds");
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
