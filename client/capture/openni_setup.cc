#include "client/capture/openni_setup.h"

#include <ostream>
#include <set>
#include <tuple>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

using Mode = std::tuple<int, int, int>;  // width, height, frames a second

std::string Text(const Mode& mode) {
  const auto [width, height, fps] = mode;
  return std::to_string(width) + "x" + std::to_string(height) + " at " + std::to_string(fps);
}

Mode ModeOf(const openni::VideoMode& mode) {
  return {mode.getResolutionX(), mode.getResolutionY(), mode.getFps()};
}

std::set<Mode> ModesOf(const openni::VideoStream& stream,
                       std::initializer_list<openni::PixelFormat> formats) {
  std::set<Mode> modes;
  const auto& all = stream.getSensorInfo().getSupportedVideoModes();
  for (int i = 0; i < all.getSize(); ++i) {
    for (const openni::PixelFormat format : formats) {
      if (all[i].getPixelFormat() == format) modes.insert(ModeOf(all[i]));
    }
  }
  return modes;
}

bool SetMode(openni::VideoStream& stream, const Mode& wanted, openni::PixelFormat format) {
  const auto& all = stream.getSensorInfo().getSupportedVideoModes();
  for (int i = 0; i < all.getSize(); ++i) {
    if (all[i].getPixelFormat() != format || ModeOf(all[i]) != wanted) continue;
    return stream.setVideoMode(all[i]) == openni::STATUS_OK;
  }
  return false;
}

void Create(openni::Device& device, openni::SensorType type, const char* name,
            openni::VideoStream& stream) {
  if (!device.hasSensor(type)) throw CameraError(std::string("the camera has no ") + name);
  if (stream.create(device, type) != openni::STATUS_OK) {
    throw CameraError(std::string("the camera gives no ") + name + ": " + OpenNiReason());
  }
}

}  // namespace

std::string CommonModes(const Streams& streams) {
  const std::set<Mode> depth =
      ModesOf(streams.depth, {openni::PIXEL_FORMAT_DEPTH_1_MM, openni::PIXEL_FORMAT_DEPTH_100_UM});
  std::string text;
  for (const Mode& mode : ModesOf(streams.color, {openni::PIXEL_FORMAT_RGB888})) {
    if (depth.contains(mode)) text += (text.empty() ? "" : ", ") + Text(mode);
  }
  return text.empty() ? "none" : text;
}

void CreateStreams(openni::Device& device, Streams& streams) {
  Create(device, openni::SENSOR_DEPTH, "depth", streams.depth);
  Create(device, openni::SENSOR_COLOR, "colour", streams.color);
}

void SetModes(const CameraOptions& options, Streams& streams) {
  const Mode wanted{options.size.width, options.size.height, options.fps};
  const bool depth_set = SetMode(streams.depth, wanted, openni::PIXEL_FORMAT_DEPTH_1_MM) ||
                         SetMode(streams.depth, wanted, openni::PIXEL_FORMAT_DEPTH_100_UM);
  if (depth_set && SetMode(streams.color, wanted, openni::PIXEL_FORMAT_RGB888)) return;
  throw CameraError("the camera has no mode " + Text(wanted) +
                    " frames/s for colour and depth; it has: " + CommonModes(streams));
}

bool SetRegistration(openni::Device& device) {
  const auto mode = openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR;
  return device.isImageRegistrationModeSupported(mode) &&
         device.setImageRegistrationMode(mode) == openni::STATUS_OK &&
         device.getImageRegistrationMode() == mode;
}

void SetSyncAndMirror(openni::Device& device, Streams& streams, std::ostream& notes) {
  if (device.setDepthColorSyncEnabled(true) != openni::STATUS_OK) {
    notes << "note: the camera does not synchronise colour and depth; frames are paired by time\n";
  }
  for (openni::VideoStream* stream : {&streams.color, &streams.depth}) {
    if (stream->setMirroringEnabled(false) == openni::STATUS_OK) continue;
    // Harmless where it does not mirror anyway.
    if (!stream->getMirroringEnabled()) continue;
    throw CameraError("the camera mirrors its images and cannot be told not to");
  }
}

void CheckModes(const CameraOptions& options, const Streams& streams) {
  const Mode wanted{options.size.width, options.size.height, options.fps};
  for (const openni::VideoStream* stream : {&streams.color, &streams.depth}) {
    const Mode mode = ModeOf(stream->getVideoMode());
    if (mode == wanted) continue;
    throw CameraError("the camera took " + Text(mode) + " frames/s where " + Text(wanted) +
                      " was set");
  }
}

}  // namespace fovea::capture
