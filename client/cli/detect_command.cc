#include "client/cli/detect_command.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "client/cli/batch.h"
#include "client/cli/explain.h"
#include "client/cli/output_check.h"
#include "client/cli/parsing.h"
#include "client/cli/report.h"
#include "client/client.h"
#include "client/images.h"

namespace fovea::cli {
namespace {

void Require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

FrameSettings SettingsOf(const DetectFlags& flags) {
  FrameSettings settings;
  settings.intrinsics = ParseIntrinsics(flags.intrinsics, "--intrinsics");
  settings.depth_camera = ParseDepthCamera(flags.depth_intrinsics, flags.color_from_depth);
  // The server takes 0 for "not said" and means millimetres.
  Require(flags.depth_unit_m > 0 && flags.depth_unit_m <= 1,
          fmt::format("--depth-unit: {} is not above 0 and at most 1 metre (0.001 for depth in "
                      "millimetres)",
                      flags.depth_unit_m));
  settings.depth_unit_m = flags.depth_unit_m;
  settings.gravity = ParseGravity(flags.gravity);
  settings.options = ParseOptions(flags.profile, flags.settings);
  Require(flags.time_budget_s >= 0 && flags.time_budget_s < 3600,
          fmt::format("--time-budget: {} is not from 0 (none) to less than an hour",
                      flags.time_budget_s));
  if (flags.time_budget_s > 0) {
    *settings.options.mutable_time_budget() =
        google::protobuf::util::TimeUtil::NanosecondsToDuration(
            std::llround(flags.time_budget_s * 1e9));
  }
  return settings;
}

std::chrono::milliseconds TimeoutOf(const DetectFlags& flags) {
  Require(flags.timeout_s > 0 && flags.timeout_s <= 3600,
          fmt::format("--timeout: {} is not above 0 and at most 3600 seconds", flags.timeout_s));
  return std::chrono::milliseconds(std::llround(std::ceil(flags.timeout_s * 1000)));
}

bool WantsSingleOutputs(const OutputPaths& paths) {
  return !(paths.labels + paths.json + paths.overlay + paths.cloud + paths.saliency_prefix +
           paths.steps)
              .empty();
}

// "learn0" of "frames/learn0_color.png".
std::string NameOf(const std::string& color_path) {
  const std::string stem = std::filesystem::path(color_path).stem().string();
  const std::size_t end = stem.rfind("_color");
  return end == std::string::npos || end == 0 ? stem : stem.substr(0, end);
}

int DetectOne(const DetectFlags& flags, const client::Client& client) {
  FrameSettings settings = SettingsOf(flags);
  RequestFor(flags.outputs, &settings.options);
  const FrameFiles files{flags.id.empty() ? NameOf(flags.color) : flags.id, flags.color,
                         flags.depth};
  CheckOutputs(flags.outputs, files);
  const v1::DetectRequest request = MakeRequest(files, settings);

  const auto start = std::chrono::steady_clock::now();
  const v1::DetectResponse response = client.Detect(request, TimeoutOf(flags));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;

  std::cout << files.id << ": " << Report(response.detections(), took.count());
  WriteOutputs(flags.outputs, files, settings, request, response.detections());
  return EXIT_SUCCESS;
}

int DetectMany(const DetectFlags& flags, const client::Client& client) {
  Require(!flags.output.empty(), "--input needs --output: the folder to write to");
  Require(flags.color.empty() && flags.depth.empty() && !WantsSingleOutputs(flags.outputs),
          "--input and --output are for whole folders; --color, --depth and the outputs of a "
          "single frame do not go with them");
  const bool all_done =
      DetectFolder(client, flags.input, flags.output, SettingsOf(flags), TimeoutOf(flags),
                   [&](const client::RpcError& error) { return ExplainDetect(error, flags); });
  return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
}

CLI::Option* AddFlag(CLI::App& command, const char* flag, std::string& value, const char* type,
                     const char* help) {
  return command.add_option(flag, value, help)->type_name(type);
}

void AddCommonFlags(CLI::App& command, DetectFlags& flags) {
  AddConnectionFlags(command, flags.connection);
  command.add_option("--timeout", flags.timeout_s, "Longest wait for one answer")
      ->type_name("SECONDS")
      ->capture_default_str();
  command
      .add_option("--time-budget", flags.time_budget_s,
                  "Longest detection: what is most salient is looked at first, and the answer is "
                  "what has been found by then; 0 = as long as it takes. Not with --explain")
      ->type_name("SECONDS")
      ->capture_default_str();
  AddFlag(command, "--intrinsics", flags.intrinsics, "FX,FY,CX,CY",
          "Of the colour camera in pixels, for example 525,525,319.5,239.5; required");
  AddFlag(command, "--depth-intrinsics", flags.depth_intrinsics, "FX,FY,CX,CY",
          "Of the depth camera in pixels of the depth image, where depth is not registered to "
          "colour");
  AddFlag(command, "--color-from-depth", flags.color_from_depth, "X,Y,Z,QX,QY,QZ,QW",
          "With it: position (metres) and orientation (unit quaternion) of the depth camera in "
          "the colour camera's frame (x right, y down, z forward)");
  command.add_option("--depth-unit", flags.depth_unit_m, "Metres per unit of the depth image")
      ->type_name("METRES")
      ->capture_default_str();
  AddFlag(command, "--gravity", flags.gravity, "X,Y,Z",
          "Unit vector that points down in the camera frame (x right, y down, z forward); "
          "estimated from the scene where absent");
  AddFlag(command, "--profile", flags.profile, "NAME", "Settings to start from: default or paper");
  command.add_option("--set", flags.settings, "Changes one option; may be repeated")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
}

void AddFrameFlags(CLI::App& command, DetectFlags& flags) {
  const char* group = "One frame";
  OutputPaths& outputs = flags.outputs;
  AddFlag(command, "--color", flags.color, "FILE", "Colour image, PNG or JPEG")->group(group);
  AddFlag(command, "--depth", flags.depth, "FILE",
          "16-bit PNG, 0 = not measured; registered to colour unless --color-from-depth is given")
      ->group(group);
  AddFlag(command, "--id", flags.id, "NAME", "Name of the frame; else that of the colour file")
      ->group(group);
  AddFlag(command, "--labels", outputs.labels, "FILE",
          "Write the label image: 0 = background, k = object k")
      ->group(group);
  AddFlag(command, "--json", outputs.json, "FILE", "Write the whole answer")->group(group);
  AddFlag(command, "--overlay", outputs.overlay, "FILE", "Write a picture of what was found")
      ->group(group);
  AddFlag(command, "--cloud", outputs.cloud, "FILE", "Write the coloured point cloud as PLY")
      ->group(group);
  AddFlag(command, "--saliency", outputs.saliency_prefix, "PREFIX",
          "Write the saliency maps to PREFIX_color.png and PREFIX_depth.png")
      ->group(group);
  AddFlag(command, "--explain", outputs.steps, "FOLDER",
          "Write a picture of every step, from depth and saliency over seeds and hypotheses to the "
          "objects, and index.html, which shows them; made where it is missing")
      ->group(group);
}

void AddFolderFlags(CLI::App& command, DetectFlags& flags) {
  const char* group = "A folder of frames";
  AddFlag(command, "--input", flags.input, "FOLDER",
          "Every NAME_color.png (or .jpg) with its NAME_depth.png")
      ->group(group);
  AddFlag(
      command, "--output", flags.output, "FOLDER",
      "For NAME.png (labels), NAME.json and NAME_overlay.png, which are overwritten; made where "
      "it is missing; not the folder of --input")
      ->group(group);
}

}  // namespace

void AddDetectFlags(CLI::App& command, DetectFlags& flags) {
  AddCommonFlags(command, flags);
  AddFrameFlags(command, flags);
  AddFolderFlags(command, flags);
}

std::string ExplainDetect(const client::RpcError& error, const DetectFlags& flags) {
  return Explain(error, flags.connection, fmt::format("{} s (--timeout)", flags.timeout_s));
}

int RunDetect(const DetectFlags& flags) {
  // Not CLI11's `required`: it would be reported before a misspelt flag.
  Require(!flags.intrinsics.empty(),
          "--intrinsics is required: FX,FY,CX,CY of the colour camera in pixels");
  const client::Client client = Connect(flags.connection);
  if (!flags.input.empty()) return DetectMany(flags, client);
  Require(flags.output.empty(), "--output needs --input: the folder to read from");
  Require(!flags.color.empty() && !flags.depth.empty(),
          "give --color and --depth for one frame, or --input and --output for a folder");
  return DetectOne(flags, client);
}

}  // namespace fovea::cli
