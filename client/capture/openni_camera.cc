#include "client/capture/openni_camera.h"

#include <cstdio>
#include <utility>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

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

std::optional<Picture> OpenNiCamera::Next(std::chrono::milliseconds patience) {
  if (watch_.Unplugged()) throw CameraLost("the camera " + uri_ + " was unplugged");
  if (!read_ && device_.isFile()) SetSpeed(options_.speed);
  read_ = true;
  if (const auto ready = Await(patience)) return Read(*ready);
  CheckSilence();
  return std::nullopt;
}

bool OpenNiCamera::ImageWaits() const { return Await(std::chrono::milliseconds(0)).has_value(); }

std::optional<std::size_t> OpenNiCamera::Await(std::chrono::milliseconds patience) const {
  int ready = 0;
  const openni::Status status = openni::OpenNI::waitForAnyStream(
      const_cast<openni::VideoStream**>(both_.data()), static_cast<int>(both_.size()), &ready,
      static_cast<int>(patience.count()));
  if (status != openni::STATUS_OK) return std::nullopt;
  return static_cast<std::size_t>(ready);
}

std::optional<Picture> OpenNiCamera::Read(std::size_t index) {
  openni::VideoFrameRef frame;
  if (both_[index]->readFrame(&frame) != openni::STATUS_OK) return std::nullopt;
  const bool is_depth = index == 1;
  const int gap = frame.getFrameIndex() - std::exchange(last_index_[index], frame.getFrameIndex());
  if (is_depth && delivered_ && gap > 1) losses_.missed += static_cast<std::uint64_t>(gap - 1);
  const bool cut = frame.getDataSize() < frame.getStrideInBytes() * frame.getHeight();
  if (cut || cv::Size(frame.getWidth(), frame.getHeight()) != options_.size) {
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
  silent_since_ = steady_clock::now();
  Picture picture;
  picture.color = std::move(pair->color);
  picture.depth = std::move(pair->depth);
  picture.depth_unit_m = depth_unit_m_;
  picture.device_time_us = pair->depth_time_us;
  picture.captured_at = std::chrono::system_clock::now();
  picture.arrived = silent_since_;
  return picture;
}

bool OpenNiCamera::AtEnd() const {
  if (!device_.isFile()) return false;
  auto* playback = const_cast<openni::Device&>(device_).getPlaybackControl();
  return last_index_[0] >= playback->getNumberOfFrames(streams_.color) &&
         last_index_[1] >= playback->getNumberOfFrames(streams_.depth);
}

void OpenNiCamera::CheckSilence() const {
  const std::chrono::duration<double> silence = steady_clock::now() - silent_since_;
  if (AtEnd() || silence.count() < options_.frame_timeout_s) return;
  const std::string since = " for " + Seconds(options_.frame_timeout_s);
  if (losses_.wrong_size > 0) {
    throw CameraError("the camera " + uri_ + " sends images of another size than " +
                      std::to_string(size().width) + "x" + std::to_string(size().height) +
                      ", or cut short," + since);
  }
  const std::string text = "no frames arrive from " + uri_ + since;
  if (device_.isFile()) throw CameraError(text + ": the recording is cut short");
  if (delivered_) throw CameraLost(text);
  throw CameraError(text +
                    ": USB bandwidth? Give the camera a port of its own, without a hub, or choose "
                    "a smaller --resolution or --fps");
}

FieldOfView OpenNiCamera::StatedFieldOfView() const {
  return {streams_.color.getHorizontalFieldOfView(), streams_.color.getVerticalFieldOfView()};
}

CameraLosses OpenNiCamera::Losses() const {
  CameraLosses losses = losses_;
  losses.unpaired = pairing_->NumUnpaired();
  return losses;
}

}  // namespace fovea::capture
