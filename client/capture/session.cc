#include "client/capture/session.h"

#include <ostream>
#include <thread>
#include <utility>

#include "client/capture/stop_signal.h"

namespace fovea::capture {

bool AwaitLastAnswers(const Session& session, const std::function<bool()>& is_there) {
  using std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kBetweenLooks{20}, kSoon{500};
  const steady_clock::time_point start = steady_clock::now();
  for (bool told = false; !is_there();) {
    const auto waited = steady_clock::now() - start;
    if (waited >= kLastAnswers || StopDemanded()) return false;
    if (waited >= kSoon && !std::exchange(told, true)) {
      session.notes << "waiting for the last answers, " << kLastAnswers.count()
                    << " s at most; Ctrl-C or another signal ends that" << std::endl;
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return true;
}

bool GoesOn(const SessionOptions& options, const Session& session) {
  return !StopAsked() && session.source.NumPictures() < options.max_frames &&
         std::chrono::steady_clock::now() < options.end && !session.source.AtEnd();
}

void SetCameras(const SessionOptions& options, v1::Frame* frame) {
  *frame->mutable_intrinsics() = options.intrinsics;
  if (!options.depth_camera) return;
  *frame->mutable_depth_intrinsics() = options.depth_camera->intrinsics;
  *frame->mutable_color_from_depth() = options.depth_camera->color_from_depth;
}

v1::Frame MakeFrame(const SessionOptions& options, const Picture& picture, Encoder& encoder) {
  if (options.depth_camera) cli::CheckDepthSize(*options.depth_camera, picture.depth.size());
  v1::Frame frame = encoder.Encode(picture);
  SetCameras(options, &frame);
  if (options.gravity) *frame.mutable_gravity() = *options.gravity;
  return frame;
}

}  // namespace fovea::capture
