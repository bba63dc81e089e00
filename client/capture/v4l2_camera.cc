#include "client/capture/v4l2_camera.h"

#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// Of "v4l2:DEPTH,COLOR".
std::pair<std::string, std::string> NodesOf(const std::string& device) {
  const std::string nodes = device.substr(device.find(':') + 1);
  const std::size_t comma = nodes.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == nodes.size()) {
    throw CameraError("--device: \"" + device +
                      "\" is not v4l2:DEPTH,COLOR, for example v4l2:/dev/video0,/dev/video4 "
                      "(v4l2-ctl --list-devices names the nodes)");
  }
  return {nodes.substr(0, comma), nodes.substr(comma + 1)};
}

cv::Size DepthSize(const CameraOptions& options) {
  return options.depth_size.empty() ? options.size : options.depth_size;
}

cv::Mat RgbOf(const cv::Mat& yuyv) {
  cv::Mat rgb;
  cv::cvtColor(yuyv, rgb, cv::COLOR_YUV2RGB_YUYV);
  return rgb;
}

}  // namespace

V4l2Camera::V4l2Camera(const CameraOptions& options)
    : options_(options),
      depth_(NodesOf(options.device).first, V4l2Format::kDepth, DepthSize(options), options.fps),
      color_(NodesOf(options.device).second, V4l2Format::kColor, options.size, options.fps),
      pairing_(static_cast<std::uint64_t>(500'000 / options.fps)),  // half the time between frames
      silent_since_(steady_clock::now()) {}

std::optional<Picture> V4l2Camera::Next(std::chrono::milliseconds patience) {
  std::array<pollfd, 2> both{pollfd{depth_.fd(), POLLIN, 0}, pollfd{color_.fd(), POLLIN, 0}};
  poll(both.data(), both.size(), static_cast<int>(patience.count()));
  // What is wrong with a node says the attempt to take an image.
  if (both[0].revents != 0) {
    if (auto picture = Read(depth_, true)) return picture;
  }
  if (both[1].revents != 0) {
    if (auto picture = Read(color_, false)) return picture;
  }
  CheckSilence();
  return std::nullopt;
}

void V4l2Camera::SkipWaiting() {
  depth_.Skip();
  color_.Skip();
  silent_since_ = steady_clock::now();
}

std::optional<Picture> V4l2Camera::Read(V4l2Node& node, bool is_depth) {
  const auto image = node.Take();
  if (!image) return std::nullopt;
  if (is_depth) {
    const auto last = std::exchange(last_sequence_, image->sequence);
    const std::uint32_t gap = last ? image->sequence - *last : 1;
    if (delivered_ && gap > 1) losses_.missed += gap - 1;
  }
  if (image->pixels.empty()) {
    ++losses_.wrong_size;
    return std::nullopt;
  }
  auto pair = is_depth ? pairing_.AddDepth(image->time_us, image->pixels)
                       : pairing_.AddColor(image->time_us, image->pixels);
  if (!pair) return std::nullopt;
  delivered_ = true;
  silent_since_ = steady_clock::now();
  Picture picture;
  picture.color = RgbOf(pair->color);
  picture.depth = std::move(pair->depth);
  picture.depth_unit_m = options_.depth_unit_m;
  picture.device_time_us = pair->depth_time_us;
  picture.captured_at = std::chrono::system_clock::now();
  picture.arrived = silent_since_;
  return picture;
}

void V4l2Camera::CheckSilence() const {
  const std::chrono::duration<double> silence = steady_clock::now() - silent_since_;
  if (silence.count() < options_.frame_timeout_s) return;
  const std::string text = fmt::format("no pair of images arrives from {} for {:g} s",
                                       options_.device, options_.frame_timeout_s);
  if (delivered_) throw CameraLost(text);
  throw CameraError(text +
                    ": USB bandwidth? Give the camera a port of its own, without a hub, or "
                    "choose a smaller --resolution or --fps");
}

CameraLosses V4l2Camera::Losses() const {
  CameraLosses losses = losses_;
  losses.unpaired = pairing_.NumUnpaired();
  return losses;
}

}  // namespace fovea::capture
