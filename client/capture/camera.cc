#include "client/capture/camera.h"

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <utility>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// The speed of a recording that goes on when the last frame was read.
constexpr double kAsRead = -1;

// Without the padding of its rows; the pixels are the caller's.
cv::Mat Copy(const openni::VideoFrameRef& frame, int type) {
  return cv::Mat(frame.getHeight(), frame.getWidth(), type, const_cast<void*>(frame.getData()),
                 static_cast<std::size_t>(frame.getStrideInBytes()))
      .clone();
}

std::string Seconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", seconds);
  return text;
}

}  // namespace

Camera::Camera(const CameraOptions& options, std::ostream& notes)
    : options_(options), uri_(FindDevice(options.device)), watch_(uri_) {
  if (device_.open(uri_.c_str()) != openni::STATUS_OK) {
    if (IsRecording(uri_)) throw CameraError(uri_ + " is damaged: " + OpenNiReason());
    throw CannotOpen(uri_, OpenNiReason());
  }
  CreateStreams(device_, streams_);
  device_.isFile() ? StartRecording(notes) : StartCamera(notes);
  const openni::VideoMode mode = streams_.depth.getVideoMode();
  depth_unit_m_ = mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_100_UM ? 1e-4 : 1e-3;
  const int fps = std::max(mode.getFps(), 1);
  pairing_.emplace(static_cast<std::uint64_t>(500'000 / fps));  // half the time between frames
  last_arrival_ = steady_clock::now();
}

Camera::~Camera() {
  Stop();
  for (openni::VideoStream* stream : both_) stream->destroy();
  device_.close();
}

void Camera::Stop() {
  for (openni::VideoStream* stream : both_) stream->stop();
}

void Camera::StartRecording(std::ostream& notes) {
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

void Camera::SetSpeed(double speed) {
  if (device_.getPlaybackControl()->setSpeed(static_cast<float>(speed)) == openni::STATUS_OK)
    return;
  throw CameraError(uri_ + " cannot be played at that speed: " + OpenNiReason());
}

void Camera::StartCamera(std::ostream& notes) {
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

void Camera::Start() {
  for (openni::VideoStream* stream : both_) {
    if (stream->start() == openni::STATUS_OK) continue;
    throw CameraError("the camera " + uri_ + " does not start: " + OpenNiReason());
  }
}

std::optional<Picture> Camera::Next(std::chrono::milliseconds patience) {
  if (watch_.unplugged()) throw CameraLost("the camera " + uri_ + " was unplugged");
  if (!read_ && device_.isFile()) SetSpeed(options_.speed);
  read_ = true;
  int ready = 0;
  const openni::Status status = openni::OpenNI::waitForAnyStream(
      const_cast<openni::VideoStream**>(both_.data()), static_cast<int>(both_.size()), &ready,
      static_cast<int>(patience.count()));
  if (status == openni::STATUS_OK) return Read(static_cast<std::size_t>(ready));
  CheckSilence();
  return std::nullopt;
}

std::optional<Picture> Camera::Read(std::size_t index) {
  openni::VideoFrameRef frame;
  if (both_[index]->readFrame(&frame) != openni::STATUS_OK) return std::nullopt;
  const bool is_depth = index == 1;
  const int gap = frame.getFrameIndex() - std::exchange(last_index_[index], frame.getFrameIndex());
  if (is_depth && delivered_ && gap > 1) losses_.missed += static_cast<std::uint64_t>(gap - 1);
  if (cv::Size(frame.getWidth(), frame.getHeight()) != options_.size) {
    ++losses_.wrong_size;
    CheckSilence();
    return std::nullopt;
  }
  auto pair = is_depth ? pairing_->AddDepth(frame.getTimestamp(), Copy(frame, CV_16UC1))
                       : pairing_->AddColor(frame.getTimestamp(), Copy(frame, CV_8UC3));
  if (!pair) {
    CheckSilence();
    return std::nullopt;
  }
  delivered_ = true;
  last_arrival_ = steady_clock::now();
  Picture picture;
  picture.color = std::move(pair->color);
  picture.depth = std::move(pair->depth);
  picture.depth_unit_m = depth_unit_m_;
  picture.device_time_us = pair->depth_time_us;
  picture.captured_at = std::chrono::system_clock::now();
  picture.arrived = last_arrival_;
  return picture;
}

bool Camera::AtEnd() const {
  if (!device_.isFile()) return false;
  auto* playback = const_cast<openni::Device&>(device_).getPlaybackControl();
  return last_index_[0] >= playback->getNumberOfFrames(streams_.color) &&
         last_index_[1] >= playback->getNumberOfFrames(streams_.depth);
}

void Camera::CheckSilence() const {
  const std::chrono::duration<double> silence = steady_clock::now() - last_arrival_;
  if (AtEnd() || silence.count() < options_.frame_timeout_s) return;
  const std::string since = " for " + Seconds(options_.frame_timeout_s);
  if (losses_.wrong_size > 0) {
    throw CameraError("the camera " + uri_ + " sends images of another size than " +
                      std::to_string(size().width) + "x" + std::to_string(size().height) + since);
  }
  const std::string text = "no frames arrive from " + uri_ + since;
  if (device_.isFile()) throw CameraError(text + ": the recording is cut short");
  if (delivered_) throw CameraLost(text);
  throw CameraError(text +
                    ": USB bandwidth? Give the camera a port of its own, without a hub, or choose "
                    "a smaller --resolution or --fps");
}

FieldOfView Camera::field_of_view() const {
  return {streams_.color.getHorizontalFieldOfView(), streams_.color.getVerticalFieldOfView()};
}

CameraLosses Camera::losses() const {
  CameraLosses losses = losses_;
  losses.unpaired = pairing_->num_unpaired();
  return losses;
}

}  // namespace fovea::capture
