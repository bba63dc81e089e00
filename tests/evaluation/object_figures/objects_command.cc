#include "tests/evaluation/object_figures/objects_command.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/evaluation/object_figures/object_export.h"
#include "tests/evaluation/object_figures/object_report.h"
#include "tests/evaluation/output.h"

namespace fovea::evaluation {
namespace {

void Run(const GeneratedFlags& flags) {
  const ObjectRun run = RunObjects(flags);
  PrintObjects(std::cout, run);
  WriteJson(flags.json, ToJson(run));
  const std::vector<Chart> charts = ObjectCharts(run);
  if (!flags.plot.empty() && charts.empty()) {
    throw std::runtime_error("--plot: no object that is seen to 90 % was found");
  }
  WriteText(flags.plot, DrawSvg(charts));
}

}  // namespace

void AddObjectsCommand(CLI::App& app) {
  auto flags = std::make_shared<GeneratedFlags>();
  CLI::App* command = app.add_subcommand(
      "objects", "Compare boxes, shapes and relations in generated scenes with the truth");
  AddGeneratedFlags(*command, *flags);
  AddFigureFlags(*command, *flags);
  command->add_flag("--leaning", flags->leaning,
                    "Lean a book against a box of each scene that has one");
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
