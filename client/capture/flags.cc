#include "client/capture/flags.h"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "flags/finite_range.h"

namespace fovea::capture {
namespace {

constexpr const char* kCamera = "Camera";
constexpr const char* kCalibration = "Calibration";
constexpr const char* kSending = "Detection";
constexpr const char* kOutput = "Output";
constexpr const char* kLimits = "When to stop";

void AddCameraFlags(CLI::App& command, CameraFlags& flags) {
  command
      .add_option(
          "--device", flags.device,
          "URI of the camera, FILE.oni, or v4l2:DEPTH,COLOR with video nodes of the kernel, "
          "such as v4l2:/dev/video0,/dev/video4; else the first one of OpenNI2")
      ->type_name("URI|FILE.oni|v4l2:NODES")
      ->group(kCamera);
  command.add_option("--resolution", flags.resolution, "Of colour and depth")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str()
      ->group(kCamera);
  command.add_option("--fps", flags.fps, "Frames a second")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->group(kCamera);
  command
      .add_flag("--allow-unregistered", flags.allow_unregistered,
                "Go on where depth cannot be registered to colour")
      ->group(kCamera);
}

// Which OpenNI2 knows of its cameras.
void AddV4l2Flags(CLI::App& command, StreamFlags& flags) {
  const char* group = "Camera of v4l2";
  command
      .add_option("--depth-resolution", flags.camera.depth_resolution,
                  "Of depth, where it is not that of colour")
      ->type_name("WIDTHxHEIGHT")
      ->group(group);
  command
      .add_option("--depth-unit", flags.camera.depth_unit_m,
                  "Metres per unit of depth; 0.001 unless given")
      ->type_name("METRES")
      ->check(flags::FiniteRange(1e-6, 1))
      ->group(group);
  command
      .add_option("--depth-intrinsics", flags.depth_intrinsics,
                  "Of the depth camera: numbers in pixels, or a calibration file")
      ->type_name("FX,FY,CX,CY|FILE")
      ->group(group);
  command
      .add_option("--color-from-depth", flags.color_from_depth,
                  "Position (metres) and orientation (unit quaternion) of the depth camera in the "
                  "colour camera's frame; the server registers depth by both")
      ->type_name("X,Y,Z,QX,QY,QZ,QW")
      ->group(group);
}

void AddFrameTimeout(CLI::App& command, CameraFlags& flags) {
  command.add_option("--frame-timeout", flags.frame_timeout_s, "Longest time without a frame")
      ->type_name("SECONDS")
      ->check(flags::FiniteRange(0.1, 3600))
      ->capture_default_str()
      ->group(kCamera);
}

void AddLimitFlags(CLI::App& command, LimitFlags& flags) {
  command.add_option("--frames", flags.frames, "After so many frames")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62U, "a whole number from 1"))
      ->group(kLimits);
  command.add_option("--seconds", flags.seconds, "After this time")
      ->type_name("N")
      ->check(flags::FiniteRange(1e-3, 1e9))
      ->group(kLimits);
}

void AddCalibrationFlags(CLI::App& command, IntrinsicsFlags& flags) {
  CLI::Option* file =
      command.add_option("--calibration", flags.calibration_path,
                         "ROS camera_info, YAML or JSON, or JSON with fx, fy, cx, cy, "
                         "width, height; else --intrinsics, else what the camera "
                         "states");
  file->type_name("FILE")->group(kCalibration);
  command
      .add_option(
          "--intrinsics", flags.numbers_or_file,
          "Of the colour camera in pixels, for example 525,525,319.5,239.5, or a file as above")
      ->type_name("FX,FY,CX,CY|FILE")
      ->excludes(file)
      ->group(kCalibration);
  command
      .add_option("--distortion", flags.distortion,
                  "Of the lens, in place of the calibration's: plumb_bob, rational_polynomial or "
                  "equidistant with OpenCV's coefficients, or none")
      ->type_name("MODEL=K1,K2,...")
      ->group(kCalibration);
}

void AddDetectionFlags(CLI::App& command, StreamFlags& flags) {
  cli::AddQuestionFlags(command, flags.question, kSending);
  command
      .add_flag(
          "--track", flags.track,
          "Objects keep a number from frame to frame, in overlays (#17) and JSON (track_id); of "
          "recordings with --speed, not with --every-frame")
      ->group(kSending);
  command.add_option("--gravity", flags.gravity, "Unit vector that points down; else estimated")
      ->type_name("X,Y,Z")
      ->group(kSending);
  command.add_option("--color-encoding", flags.color_encoding, "jpeg, or rgb8 without loss")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kSending);
  command.add_option("--jpeg-quality", flags.jpeg_quality, "Of colour")
      ->type_name("1-100")
      ->check(CLI::Range(1, 100))
      ->capture_default_str()
      ->group(kSending);
}

void AddStreamFlags(CLI::App& command, StreamFlags& flags) {
  cli::AddConnectionFlags(command, flags.connection);
  command.add_flag("--any-version", flags.any_version, "Try servers of other versions, too")
      ->group("Server");
  command
      .add_option("--patience", flags.patience_s,
                  "How long to wait for a server or a camera that went away")
      ->type_name("SECONDS")
      ->check(flags::FiniteRange(0, 1e6))
      ->capture_default_str()
      ->group("Server");
  AddFrameTimeout(command, flags.camera);
  AddLimitFlags(command, flags.limits);
  AddCalibrationFlags(command, flags.intrinsics);
  AddDetectionFlags(command, flags);
  command.add_flag("--view", flags.view, "Show a window: colour, objects, depth")->group(kOutput);
  command
      .add_option(
          "--save", flags.save_folder,
          "Write NAME_color.png, NAME_depth.png, NAME.png (labels), NAME.json and "
          "NAME_overlay.jpg of each answer; a folder without frames, made where it is missing")
      ->type_name("FOLDER")
      ->group(kOutput);
}

}  // namespace

void AddLiveFlags(CLI::App& command, StreamFlags& flags) {
  AddCameraFlags(command, flags.camera);
  AddV4l2Flags(command, flags);
  AddStreamFlags(command, flags);
  command
      .add_flag("--every-frame", flags.every_frame,
                "Take the next frame after the answer and drop none that was taken; a live camera "
                "goes on meanwhile, and what it sees then is not taken")
      ->group(kSending);
}

void AddReplayFlags(CLI::App& command, StreamFlags& flags) {
  command.add_option("recording", flags.camera.device, "The recording")
      ->type_name("FILE.oni")
      ->required();
  AddStreamFlags(command, flags);
  command
      .add_option("--speed", flags.speed,
                  "Play at this multiple of the recorded speed and drop frames like a camera; "
                  "else each frame waits for its answer")
      ->type_name("X")
      ->check(flags::FiniteRange(0.01, 100))
      ->group(kSending);
}

void AddRecordFlags(CLI::App& command, RecordFlags& flags) {
  AddCalibrationFlags(command, flags.intrinsics);
  command.add_option("recording", flags.path, "The recording to make")
      ->type_name("FILE.oni")
      ->required();
  AddCameraFlags(command, flags.camera);
  AddFrameTimeout(command, flags.camera);
  AddLimitFlags(command, flags.limits);
}

void RequireNoFlagsBeforeCommands(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* flag : app.get_options()) {
      if (flag->count() == 0) continue;
      throw std::invalid_argument(flag->get_name() + ": flags of " + command->get_name() +
                                  " stand behind that word");
    }
  }
}

}  // namespace fovea::capture
