#include "client/cli/detect_command.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "client/cli/bag/bag_files.h"
#include "client/cli/bag/topics.h"
#include "client/cli/batch.h"
#include "client/cli/bundled_frames.h"
#include "client/cli/explain.h"
#include "client/cli/files.h"
#include "client/cli/intrinsics_flag.h"
#include "client/cli/output_check.h"
#include "client/cli/progress.h"
#include "client/cli/registration_check.h"
#include "client/cli/report.h"
#include "client/client.h"

namespace fovea::cli {
namespace {

constexpr double kMillimetre = 0.001;

void Require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

// `from`: where `intrinsics` come from. A flag for the lens holds.
void SetLens(const DetectFlags& flags, const std::string& from, v1::CameraIntrinsics* intrinsics) {
  SetDistortion(flags.distortion, intrinsics);
  if (flags.distortion.empty() && intrinsics->has_distortion()) {
    PrintNote("lens distortion from " + from + " (--distortion none where images are rectified)");
  }
}

// What the bag says of the colour camera; false where it says nothing, or a flag does.
bool SetIntrinsicsFrom(const Bag& bag, const DetectFlags& flags, FrameSettings* settings) {
  if (!flags.intrinsics.empty()) return false;
  const std::optional<Calibration> camera = ColorCameraOf(bag);
  if (!camera) return false;
  PrintNote(fmt::format("intrinsics{} from {} of {}",
                        IsRectified(bag.color_topic) ? " of rectified images" : "", bag.info_topic,
                        flags.input));
  settings->intrinsics = IntrinsicsOf(*camera);
  settings->info_topic = bag.info_topic;
  settings->size = {camera->width, camera->height};
  SetLens(flags, bag.info_topic, &settings->intrinsics);
  return true;
}

void SetIntrinsics(const DetectFlags& flags, FrameSettings* settings) {
  const std::string beside =
      flags.intrinsics.empty() && !flags.input.empty() ? CalibrationIn(flags.input) : std::string();
  if (!beside.empty()) PrintNote("intrinsics from " + beside);
  Require(!flags.intrinsics.empty() || !beside.empty(),
          "--intrinsics is required: FX,FY,CX,CY of the colour camera in pixels, or a calibration "
          "file");
  const GivenIntrinsics given =
      ReadIntrinsics(beside.empty() ? flags.intrinsics : beside, "--intrinsics");
  settings->intrinsics = given.values;
  SetLens(flags, given.path, &settings->intrinsics);
  settings->intrinsics_path = given.path;
  settings->size = given.size;
}

// What a bundle says of cameras is sent again; a flag for that would be ignored.
void RequireNoCamera(const DetectFlags& flags) {
  Require((flags.intrinsics + flags.depth_intrinsics + flags.color_from_depth + flags.distortion +
           flags.gravity + flags.camera_pose + flags.color_topic + flags.depth_topic)
                  .empty() &&
              !flags.depth_unit_m,
          "a bundle's frames are sent as they were: flags of cameras and gravity do not go with "
          "them");
}

FrameSettings SettingsOf(const DetectFlags& flags, const std::optional<Bag>& bag = {}) {
  FrameSettings settings;
  if (IsBundle(flags.input)) {
    RequireNoCamera(flags);
  } else if (!bag || !SetIntrinsicsFrom(*bag, flags, &settings))
    SetIntrinsics(flags, &settings);
  settings.depth_camera = ParseDepthCamera(flags.depth_intrinsics, flags.color_from_depth);
  settings.gravity = ParseGravity(flags.gravity);
  settings.camera_pose = ParsePose(flags.camera_pose, "--camera-pose");
  settings.options = DetectOptionsOf(flags.question);
  return settings;
}

std::chrono::milliseconds TimeoutOf(const DetectFlags& flags) {
  Require(flags.timeout_s > 0 && flags.timeout_s <= 3600,
          fmt::format("--timeout: {} is not above 0 and at most 3600 seconds", flags.timeout_s));
  return std::chrono::milliseconds(std::llround(std::ceil(flags.timeout_s * 1000)));
}

// "learn0" of "frames/learn0_color.png".
std::string NameOf(const std::string& color_path) {
  const std::string stem = std::filesystem::path(color_path).stem().string();
  const std::size_t end = stem.rfind("_color");
  return end == std::string::npos || end == 0 ? stem : stem.substr(0, end);
}

// Said beside the answer, which does not show it: masks lie on what depth shows.
void NoteShift(const v1::DetectRequest& request, const FrameFiles& files) {
  const v1::Frame& frame = request.frame();
  if (frame.has_color_from_depth()) return;
  std::optional<cv::Point> shift;
  try {
    shift = ShiftOfDepth(DecodeColor(frame.color().data(), files.color_path),
                         DecodeDepth(frame.depth().data(), files.depth_path));
  } catch (const std::exception&) {
    return;  // the server could read them, and has answered
  }
  if (!shift) return;
  PrintNote(fmt::format(
      "depth seems to lie {} px to the {} of colour: if it is not registered to colour, "
      "--depth-intrinsics with --color-from-depth have it registered",
      std::abs(shift->x), shift->x > 0 ? "right" : "left"));
}

int DetectOne(const DetectFlags& flags, const client::Client& client) {
  FrameSettings settings = SettingsOf(flags);
  settings.depth_unit_m = flags.depth_unit_m.value_or(kMillimetre);
  Outputs outputs = flags.outputs;
  outputs.extras = ExtrasOf(flags);
  outputs.json_masks = !flags.no_masks;
  Require(flags.show.empty() || !outputs.overlay.empty(),
          "--show needs --overlay, the picture to show it in");
  RequestFor(outputs, &settings.options);
  const FrameFiles files{
      flags.id.empty() ? NameOf(flags.color) : flags.id, flags.color, flags.depth, {}};
  const ConnectionFlags& connection = flags.connection;
  CheckOutputs(outputs, files,
               {{"--intrinsics", flags.intrinsics},
                {"--depth-intrinsics", flags.depth_intrinsics},
                {"--token-file", connection.token_file},
                {"--tls-ca", connection.tls_ca},
                {"--tls-cert", connection.tls_cert},
                {"--tls-key", connection.tls_key}});
  const v1::DetectRequest request = MakeRequest(files, settings);

  const auto start = std::chrono::steady_clock::now();
  const v1::DetectResponse response = client.Detect(request, TimeoutOf(flags));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  CheckSize(settings, response.detections());

  const bool to_stdout = outputs.json == kStandardOutput;
  (to_stdout ? std::cerr : std::cout)
      << files.id << ": " << Report(response.detections(), took.count());
  NoteShift(request, files);
  if (to_stdout) std::cout << JsonLine(outputs, request, response.detections());
  WriteOutputs(outputs, files, settings, request, response.detections());
  return EXIT_SUCCESS;
}

Batch BatchOf(const DetectFlags& flags) {
  const Outputs& outputs = flags.outputs;
  const bool lines = outputs.json == kStandardOutput;
  Require(!flags.output.empty() || lines,
          "--input needs --output, the folder to write to, or --json - for a line a frame");
  Require(
      (lines || outputs.json.empty()) && (flags.color + flags.depth + flags.id + outputs.labels +
                                          outputs.overlay + outputs.saliency_prefix + outputs.steps)
                                             .empty(),
      "--input and --output are for whole folders; --color, --depth and the outputs of a "
      "single frame do not go with them");
  Require(flags.show.empty() || (!flags.output.empty() && !flags.no_overlay),
          "--show needs overlays to show it in: --output without --no-overlay");
  Require(!flags.resume || !flags.output.empty(),
          "--resume needs --output, the folder of the results that are there");
  if (!outputs.cloud.empty()) CheckCloudFormat(outputs.cloud);
  Require(outputs.height_map.empty() || outputs.height_map == "jpg",
          "--height-map: of a folder it is jpg, for NAME_height.jpg of each frame");
  Require(outputs.height_map.empty() || !flags.output.empty(),
          "--height-map of a folder needs --output");
  Require(outputs.cloud.empty() || !flags.output.empty(), "--cloud of a folder needs --output");
  Batch batch;
  batch.input = flags.input;
  batch.output = flags.output;
  batch.labels = batch.json_masks = !flags.no_masks;
  batch.overlays = !flags.no_overlay;
  batch.extras = ExtrasOf(flags);
  batch.clouds = outputs.cloud;
  batch.height_maps = !outputs.height_map.empty();
  batch.json_lines = lines;
  batch.resume = flags.resume;
  batch.jobs = flags.jobs;
  batch.depth_unit_m = flags.depth_unit_m;
  return batch;
}

int DetectMany(const DetectFlags& flags, const client::Client& client) {
  Batch batch = BatchOf(flags);
  std::optional<Bag> bag;
  batch.sent_before = IsBundle(flags.input);
  Require(
      IsBag(flags.input) || batch.sent_before || (flags.color_topic + flags.depth_topic).empty(),
      "--color-topic and --depth-topic are for bags, not for folders of images");
  if (batch.sent_before) {
    batch.list = ListBundle(flags.input);
  } else if (IsBag(flags.input)) {
    bag = OpenBag(flags.input,
                  {flags.color_topic, flags.depth_topic, flags.depth_unit_m.value_or(kMillimetre)});
    PrintNote(fmt::format("colour of {}, depth of {}", bag->color_topic, bag->depth_topic));
    batch.list = bag->list;
    batch.color_topic = bag->color_topic;
    batch.depth_topic = bag->depth_topic;
    const std::string note = NoteOfUnregistered(*bag);
    if (flags.depth_intrinsics.empty() && !note.empty()) batch.list.notes.push_back(note);
  } else {
    batch.list = ListFrames(flags.input);
  }
  PatientServer server(client, TimeoutOf(flags),
                       [&](const client::RpcError& error) { return ExplainDetect(error, flags); });
  return DetectFolder(server, std::move(batch), SettingsOf(flags, bag)) ? EXIT_SUCCESS
                                                                        : EXIT_FAILURE;
}

}  // namespace

std::string ExplainDetect(const client::RpcError& error, const DetectFlags& flags) {
  return Explain(error, flags.connection, fmt::format("{} s (--timeout)", flags.timeout_s));
}

int RunDetect(const DetectFlags& flags) {
  // The server takes 0 for "not said" and means millimetres.
  const double unit_m = flags.depth_unit_m.value_or(kMillimetre);
  Require(unit_m > 0 && unit_m <= 1,
          fmt::format("--depth-unit: {} is not above 0 and at most 1 metre (0.001 for depth in "
                      "millimetres)",
                      unit_m));
  // Not CLI11's `required`: it would be reported before a misspelt flag.
  if (flags.input.empty()) {
    Require(flags.output.empty(), "--output needs --input: the folder to read from");
    Require(!flags.intrinsics.empty(),
            "--intrinsics is required: FX,FY,CX,CY of the colour camera in pixels, or a "
            "calibration file");
    Require(!flags.color.empty() && !flags.depth.empty(),
            "give --color and --depth for one frame, or --input and --output for a folder");
  }
  const client::Client client = Connect(flags.connection);
  return flags.input.empty() ? DetectOne(flags, client) : DetectMany(flags, client);
}

}  // namespace fovea::cli
