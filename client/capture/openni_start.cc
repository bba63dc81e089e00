// How a camera or a recording is opened, set up and started.
#include <algorithm>
#include <ostream>

#include "client/capture/camera_error.h"
#include "client/capture/openni_camera.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// The speed of a recording that goes on when the last frame was read.
constexpr double kAsRead = -1;

}  // namespace

OpenNiCamera::OpenNiCamera(const CameraOptions& options, std::ostream& notes)
    : options_(options), uri_(FindDevice(options.device)), watch_(uri_) {
  if (device_.open(uri_.c_str()) != openni::STATUS_OK) {
    if (IsRecording(uri_)) throw CameraError(uri_ + " is damaged: " + OpenNiReason());
    throw CannotOpen(uri_, OpenNiReason());
  }
  CreateStreams(device_, streams_);
  device_.isFile() ? StartRecording(notes) : StartCamera(notes);
  const openni::VideoMode mode = streams_.depth.getVideoMode();
  depth_unit_m_ = mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_100_UM ? 1e-4 : 1e-3;
  period_us_ = static_cast<std::uint64_t>(1'000'000 / std::max(mode.getFps(), 1));
  pairing_.emplace(period_us_ / 2);
  silent_since_ = steady_clock::now();
}

// The player of OpenNI2 goes through its streams in a thread of its own, without a lock, until its
// device is closed, and a device can only be closed when its streams are gone: whoever closes a
// recording may crash. Stopped, it stays until the program ends.
void OpenNiCamera::Closing::operator()(Opened* opened) const {
  opened->streams.color.stop();
  opened->streams.depth.stop();
  if (opened->device.isValid() && opened->device.isFile()) {
    OpenNiRuntime::KeepUntilExit();
  } else {
    delete opened;
  }
}

void OpenNiCamera::Stop() {
  for (openni::VideoStream* stream : both_) stream->stop();
}

void OpenNiCamera::StartRecording(std::ostream& notes) {
  const openni::VideoMode color = streams_.color.getVideoMode();
  const openni::VideoMode depth = streams_.depth.getVideoMode();
  options_.size = {color.getResolutionX(), color.getResolutionY()};
  if (cv::Size(depth.getResolutionX(), depth.getResolutionY()) != options_.size) {
    throw CameraError(uri_ + ": colour and depth differ in size, so depth is not registered");
  }
  notes << "note: a recording does not say whether depth was registered to colour; it is taken as "
           "registered\n";
  device_.getPlaybackControl()->setRepeatEnabled(false);
  SetSpeed(kAsRead);  // until somebody reads, lest the start is missed
  Start();
}

void OpenNiCamera::SetSpeed(double speed) {
  if (device_.getPlaybackControl()->setSpeed(static_cast<float>(speed)) == openni::STATUS_OK)
    return;
  throw CameraError(uri_ + " cannot be played at that speed: " + OpenNiReason());
}

void OpenNiCamera::StartCamera(std::ostream& notes) {
  SetModes(options_, streams_);
  bool registered = SetRegistration(device_);
  SetSyncAndMirror(device_, streams_, notes);
  Start();
  CheckModes(options_, streams_);
  if (!registered) registered = SetRegistration(device_);  // some want to run first
  if (registered) return;
  const std::string problem = "the camera " + uri_ + " does not register depth to colour";
  if (!options_.allow_unregistered) {
    throw CameraError(problem + ", which detection needs (--allow-unregistered sends it anyway)");
  }
  notes << "note: " << problem << "; masks and positions will be off\n";
}

void OpenNiCamera::Start() {
  for (openni::VideoStream* stream : both_) {
    if (stream->start() == openni::STATUS_OK) continue;
    throw CameraError("the camera " + uri_ + " does not start: " + OpenNiReason());
  }
}

}  // namespace fovea::capture
