// fovea-eval: the detector against ground truth.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "flags/misspelling.h"
#include "server/compute_process.h"
#include "tests/evaluation/detection_command.h"
#include "tests/evaluation/grasp_figures/grasps_command.h"
#include "tests/evaluation/grasp_fit/grasp_model_command.h"
#include "tests/evaluation/kinship_command.h"
#include "tests/evaluation/object_figures/objects_command.h"
#include "tests/evaluation/object_fit/object_model_command.h"
#include "tests/evaluation/rgbd_scenes/rgbd_scenes_command.h"
#include "tests/evaluation/saliency/saliency_command.h"
#include "tests/evaluation/tracking/tracking_command.h"

namespace {

int Run(int argc, char** argv) {
  fovea::server::SetUpComputing(1);  // times are those of the server, one thread a frame
  CLI::App app{"Scores the detector and its saliency against ground truth.", "fovea-eval"};
  app.require_subcommand(1);
  fovea::evaluation::AddDetectionCommand(app);
  fovea::evaluation::AddSaliencyCommand(app);
  fovea::evaluation::AddKinshipCommand(app);
  fovea::evaluation::AddGraspModelCommand(app);
  fovea::evaluation::AddObjectModelCommand(app);
  fovea::evaluation::AddObjectsCommand(app);
  fovea::evaluation::AddGraspsCommand(app);
  fovea::evaluation::AddRgbdScenesCommand(app);
  fovea::evaluation::AddTrackingCommand(app);
  fovea::flags::NameMisspellings(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-eval: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
