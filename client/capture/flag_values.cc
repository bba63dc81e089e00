// What the flags mean.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "client/capture/flags.h"
#include "client/cli/request.h"

namespace fovea::capture {
namespace {

// Flags that would be ignored.
void CheckKindOfCamera(const StreamFlags& flags) {
  if (KindOf(flags.camera.device) != CameraKind::kOpenNi) return;
  const auto refuse_if = [](bool is_given, const std::string& flag) {
    if (!is_given) return;
    throw std::invalid_argument(flag +
                                " is for --device v4l2:…; OpenNI2 says this of its cameras itself");
  };
  refuse_if(!flags.camera.depth_resolution.empty(), "--depth-resolution");
  refuse_if(flags.camera.depth_unit_m.has_value(), "--depth-unit");
  refuse_if(!flags.depth_intrinsics.empty(), "--depth-intrinsics");
  refuse_if(!flags.color_from_depth.empty(), "--color-from-depth");
}

// Where depth is as its camera sees it, the server must know that camera.
void CheckDepthCamera(const StreamFlags& flags, const SessionOptions& options) {
  if (KindOf(flags.camera.device) != CameraKind::kV4l2) return;
  if (options.depth_camera || flags.camera.allow_unregistered) return;
  throw std::invalid_argument(
      "v4l2 does not register depth to colour: give --depth-intrinsics and --color-from-depth (or "
      "--allow-unregistered, where the camera does it)");
}

}  // namespace

CameraOptions CameraOptionsOf(const CameraFlags& flags) {
  CameraOptions options;
  options.device = flags.device;
  options.size = ParseResolution(flags.resolution, "--resolution");
  if (!flags.depth_resolution.empty()) {
    options.depth_size = ParseResolution(flags.depth_resolution, "--depth-resolution");
  }
  if (flags.depth_unit_m) options.depth_unit_m = *flags.depth_unit_m;
  options.fps = flags.fps;
  options.allow_unregistered = flags.allow_unregistered;
  options.frame_timeout_s = flags.frame_timeout_s;
  return options;
}

SessionOptions SessionOptionsOf(const StreamFlags& flags) {
  SessionOptions options;
  options.server = flags.connection.server;
  options.encoding = {ParseColorEncoding(flags.color_encoding), flags.jpeg_quality};
  CheckKindOfCamera(flags);
  options.depth_camera = cli::ParseDepthCamera(flags.depth_intrinsics, flags.color_from_depth);
  CheckDepthCamera(flags, options);
  options.gravity = cli::ParseGravity(flags.gravity);
  options.detection = cli::DetectOptionsOf(flags.question);
  if (flags.track) options.detection.mutable_tracking()->set_enabled(true);
  options.max_frames = MaxFramesOf(flags.limits);
  options.end = EndOf(flags.limits);
  options.patience = std::chrono::milliseconds(std::llround(flags.patience_s * 1000));
  return options;
}

std::chrono::steady_clock::time_point EndOf(const LimitFlags& limits) {
  using std::chrono::steady_clock;
  if (limits.seconds == 0) return steady_clock::time_point::max();
  return steady_clock::now() + std::chrono::milliseconds(std::llround(limits.seconds * 1000));
}

std::uint64_t MaxFramesOf(const LimitFlags& limits) {
  return limits.frames == 0 ? std::numeric_limits<std::uint64_t>::max() : limits.frames;
}

}  // namespace fovea::capture
