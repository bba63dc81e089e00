// fovea-clean-up: a simulated floor that a robot's program cleans up.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "flags/misspelling.h"
#include "tests/evaluation/clean_up/clean_up_report.h"
#include "tests/evaluation/output.h"
#include "tests/support/sensor_names.h"

namespace {

int Run(int argc, char** argv) {
  using namespace fovea::evaluation;  // NOLINT(google-build-using-namespace): one function
  CLI::App app{
      "Simulates floors with things on them, and a robot with two fingers and a suction cup that a "
      "program commands: clean_up of the client's examples, or yours.\n"
      "  fovea-clean-up --pictures steps -- build/examples/clean_up 127.0.0.1:50051\n"
      "The program reads a line with a fovea.v1.DetectRequest (protobuf's JSON: the frame and the "
      "grippers) from its standard input and answers with a line {\"grasp\": fovea.v1.Grasp}; the "
      "world does it and sends the next request, until the answer is {\"left\": "
      "fovea.v1.Detections} (docs/clean_up.md).",
      "fovea-clean-up"};
  CleanUpFlags flags;
  std::string json;
  app.add_option("--scenes", flags.num_scenes, "Each of a program started anew")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--things", flags.num_things, "On each floor, where there is room")
      ->check(CLI::Range(1, 30))
      ->capture_default_str();
  app.add_option("--seed", flags.first_seed, "Of the first scene; the next ones count up")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40))
      ->capture_default_str();
  app.add_option("--sensor", flags.sensor, "That sees them")
      ->check(CLI::IsMember(fovea::scenes::SensorsByName()))
      ->capture_default_str();
  app.add_option("--threads", flags.num_threads, "Scenes at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--pictures", flags.pictures, "Write a picture of each step to this folder");
  app.add_option("--json", json, "Write every step to this file")->check(WhyNotWritable);
  app.add_option("program", flags.program, "Its command line, after --")->required();
  fovea::flags::NameMisspellings(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  std::signal(SIGPIPE, SIG_IGN);  // of a program that has ended
  const auto print = [](const CleanedScene& scene) {
    PrintSteps(std::cout, scene);
    std::cout << std::endl;  // what has been done is not lost if the rest is
  };
  const std::vector<CleanedScene> scenes = CleanUp(flags, print);
  PrintSummary(std::cout, scenes);
  WriteJson(json, ToJson(scenes));
  const bool all_ended = std::all_of(scenes.begin(), scenes.end(),
                                     [](const CleanedScene& scene) { return scene.error.empty(); });
  return all_ended ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-clean-up: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
