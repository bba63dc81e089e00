#include "client/cli/detect_command.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "client/cli/batch.h"
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
  const auto k = ParseNumbers(flags.intrinsics, 4, "--intrinsics", "FX,FY,CX,CY");
  settings.intrinsics = client::MakeIntrinsics(k[0], k[1], k[2], k[3]);
  settings.depth_unit_m = flags.depth_unit_m;
  if (!flags.gravity.empty()) {
    const auto g = ParseNumbers(flags.gravity, 3, "--gravity", "X,Y,Z");
    settings.gravity.emplace();
    settings.gravity->set_x(g[0]);
    settings.gravity->set_y(g[1]);
    settings.gravity->set_z(g[2]);
  }
  settings.options.set_profile(flags.profile);
  for (const std::string& text : flags.settings) {
    const auto [name, value] = ParseSetting(text);
    (*settings.options.mutable_parameters())[name] = value;
  }
  return settings;
}

std::chrono::milliseconds TimeoutOf(const DetectFlags& flags) {
  Require(flags.timeout_s > 0 && flags.timeout_s <= 3600,
          "--timeout: must be above 0 and at most 3600 seconds");
  return std::chrono::milliseconds(std::llround(std::ceil(flags.timeout_s * 1000)));
}

bool WantsSingleOutputs(const OutputPaths& paths) {
  return !(paths.labels + paths.json + paths.overlay + paths.cloud + paths.saliency_prefix).empty();
}

int DetectOne(const DetectFlags& flags, const client::Client& client) {
  FrameSettings settings = SettingsOf(flags);
  RequestFor(flags.outputs, &settings.options);
  const std::string stem = std::filesystem::path(flags.color).stem().string();
  const FrameFiles files{flags.id.empty() ? stem : flags.id, flags.color, flags.depth};
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
      DetectFolder(client, flags.input, flags.output, SettingsOf(flags), TimeoutOf(flags));
  return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

void AddDetectFlags(CLI::App& command, DetectFlags& flags) {
  command.add_option("--server", flags.server, "Address of the server, HOST:PORT")
      ->capture_default_str();
  command.add_option("--timeout", flags.timeout_s, "Longest wait for an answer in seconds")
      ->capture_default_str();
  command
      .add_option("--intrinsics", flags.intrinsics,
                  "FX,FY,CX,CY of the colour camera in pixels, for example 525,525,319.5,239.5")
      ->required();
  command.add_option("--depth-unit", flags.depth_unit_m, "Metres per unit of the depth image")
      ->capture_default_str();
  command.add_option("--gravity", flags.gravity,
                     "X,Y,Z: unit vector that points down in the camera frame (x right, y down, z "
                     "forward); estimated from the scene where absent");
  command.add_option("--profile", flags.profile, "Settings to start from: default or paper");
  command.add_option("--set", flags.settings, "NAME=NUMBER: changes one option; may be repeated");

  const char* one = "One frame";
  command.add_option("--color", flags.color, "Colour image, PNG or JPEG")->group(one);
  command.add_option("--depth", flags.depth, "16-bit PNG, registered to colour, 0 = not measured")
      ->group(one);
  command.add_option("--id", flags.id, "Name of the frame; else that of the colour file")
      ->group(one);
  command.add_option("--labels", flags.outputs.labels, "Write label image: 0 = none, k = object k")
      ->group(one);
  command.add_option("--json", flags.outputs.json, "Write the whole answer as JSON")->group(one);
  command.add_option("--overlay", flags.outputs.overlay, "Write a picture of what was found")
      ->group(one);
  command.add_option("--cloud", flags.outputs.cloud, "Write the coloured point cloud as PLY")
      ->group(one);
  command
      .add_option("--saliency", flags.outputs.saliency_prefix,
                  "Write saliency maps to PREFIX_color.png and PREFIX_depth.png")
      ->group(one);

  const char* folder = "A folder of frames";
  command
      .add_option("--input", flags.input, "Folder with NAME_color.png (or .jpg), NAME_depth.png")
      ->group(folder);
  command
      .add_option("--output", flags.output,
                  "Folder for NAME.png (labels), NAME.json and NAME_overlay.png")
      ->group(folder);
}

int RunDetect(const DetectFlags& flags) {
  const client::Client client(flags.server);
  if (!flags.input.empty()) return DetectMany(flags, client);
  Require(flags.output.empty(), "--output needs --input: the folder to read from");
  Require(!flags.color.empty() && !flags.depth.empty(),
          "give --color and --depth for one frame, or --input and --output for a folder");
  return DetectOne(flags, client);
}

}  // namespace fovea::cli
