#include "client/capture/session.h"

#include "client/capture/stop_signal.h"

namespace fovea::capture {

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
