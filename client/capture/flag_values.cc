// What the flags mean.
#include <cmath>
#include <limits>

#include "client/capture/flags.h"
#include "client/cli/request.h"

namespace fovea::capture {

CameraOptions CameraOptionsOf(const CameraFlags& flags) {
  CameraOptions options;
  options.device = flags.device;
  options.size = ParseResolution(flags.resolution);
  options.fps = flags.fps;
  options.allow_unregistered = flags.allow_unregistered;
  options.frame_timeout_s = flags.frame_timeout_s;
  return options;
}

SessionOptions SessionOptionsOf(const StreamFlags& flags) {
  SessionOptions options;
  options.encoding = {ParseColorEncoding(flags.color_encoding), flags.jpeg_quality};
  options.gravity = cli::ParseGravity(flags.gravity);
  options.detection = cli::ParseOptions(flags.profile, flags.settings);
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
