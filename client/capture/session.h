// From the camera to the server and back.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>

#include "client/capture/camera_source.h"
#include "client/capture/encoding.h"
#include "client/capture/results.h"
#include "client/capture/tally.h"
#include "client/capture/viewer.h"
#include "client/cli/request.h"
#include "client/client.h"

namespace fovea::capture {

struct SessionOptions {
  std::string server;  // its address, for people
  EncodingOptions encoding;
  v1::CameraIntrinsics intrinsics;
  std::optional<cli::DepthCamera> depth_camera;  // of depth that is not registered to colour
  std::optional<v1::Vector3> gravity;
  v1::DetectOptions detection;
  std::uint64_t max_frames = std::numeric_limits<std::uint64_t>::max();
  std::chrono::steady_clock::time_point end = std::chrono::steady_clock::time_point::max();
  std::chrono::milliseconds patience{60'000};  // with a server that is away
};

// What both ways of a session use; the caller owns all of it.
struct Session {
  const client::Client& client;
  CameraSource& source;
  Results& results;
  Viewer* viewer;  // null = none
  Tally& tally;
  std::ostream& notes;
};

// For the answers that are under way when no more pictures are sent; a server that hangs has none.
constexpr std::chrono::seconds kLastAnswers{10};

// Waits for them: calls `is_there` from time to time, and says that it waits where they do not come
// soon. False where the time is over, or a person does not want to wait.
bool AwaitLastAnswers(const Session& session, const std::function<bool()>& is_there);

// Both return at the end of the recording, at the limits of `options`, when a person asks for it,
// and throw std::exception when it cannot go on; what is under way is answered before.

// As the camera delivers: the newest picture is sent, the server answers the newest it has.
void RunLive(const SessionOptions& options, const Session& session);

// Each picture waits for the answer to the one before it; none is dropped.
void RunEveryFrame(const SessionOptions& options, const Session& session);

// Whether to take another picture.
bool GoesOn(const SessionOptions& options, const Session& session);

// Intrinsics and, where depth is not registered, its camera.
void SetCameras(const SessionOptions& options, v1::Frame* frame);

// The request for a picture, with everything that all requests have in common. Throws
// std::runtime_error where the depth camera is said to have images of another size.
v1::Frame MakeFrame(const SessionOptions& options, const Picture& picture, Encoder& encoder);

}  // namespace fovea::capture
