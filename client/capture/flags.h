// The flags of fovea-capture as they were written.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "client/capture/camera_options.h"
#include "client/capture/intrinsics.h"
#include "client/capture/session.h"
#include "client/cli/connection.h"
#include "client/cli/question_flags.h"

namespace fovea::capture {

struct CameraFlags {
  std::string device, resolution = "640x480";
  std::string depth_resolution;        // of v4l2
  std::optional<double> depth_unit_m;  // of v4l2; none = a millimetre
  int fps = 30;
  bool allow_unregistered = false;
  double frame_timeout_s = 5;
};

struct LimitFlags {
  std::uint64_t frames = 0;  // 0 = no limit
  double seconds = 0;        // 0 = no limit
};

struct StreamFlags {
  cli::ConnectionFlags connection;
  CameraFlags camera;
  LimitFlags limits;
  IntrinsicsFlags intrinsics;
  std::string depth_intrinsics, color_from_depth;  // of v4l2
  std::string color_encoding = "jpeg", gravity, save_folder;
  int jpeg_quality = 90;
  cli::QuestionFlags question;
  bool track = false;
  bool every_frame = false, view = false, any_version = false;
  double patience_s = 60, speed = 0;  // speed 0 = as fast as the answers come
};

struct RecordFlags {
  std::string path;
  CameraFlags camera;
  IntrinsicsFlags intrinsics;
  LimitFlags limits;
};

void AddLiveFlags(CLI::App& command, StreamFlags& flags);
void AddReplayFlags(CLI::App& command, StreamFlags& flags);
void AddRecordFlags(CLI::App& command, RecordFlags& flags);

// All throw std::invalid_argument that names the flag.

// For flags of the live camera that stand before a command, which would ignore them.
void RequireNoFlagsBeforeCommands(const CLI::App& app);
CameraOptions CameraOptionsOf(const CameraFlags& flags);
// Everything but the intrinsics; the time starts now.
SessionOptions SessionOptionsOf(const StreamFlags& flags);
// The moment at which `seconds` are over.
std::chrono::steady_clock::time_point EndOf(const LimitFlags& limits);
std::uint64_t MaxFramesOf(const LimitFlags& limits);

}  // namespace fovea::capture
