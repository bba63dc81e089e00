#include "client/capture/devices.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

std::atomic<bool> kept = false;

std::vector<DeviceName> Cameras() {
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<DeviceName> cameras;
  for (int i = 0; i < devices.getSize(); ++i) {
    const std::string uri = devices[i].getUri();
    // OpenNI2 brings a driver without a camera, whose pictures are empty, and lists the recordings
    // that were opened.
    if (uri.starts_with("Dummy") || IsRecording(uri)) continue;
    cameras.push_back({uri, std::string(devices[i].getVendor()) + ", " + devices[i].getName()});
  }
  return cameras;
}

}  // namespace

OpenNiRuntime::OpenNiRuntime() {
  if (openni::OpenNI::initialize() != openni::STATUS_OK) {
    throw CameraError("OpenNI2 does not start: " + OpenNiReason());
  }
}

OpenNiRuntime::~OpenNiRuntime() {
  if (!kept) openni::OpenNI::shutdown();
}

void OpenNiRuntime::KeepUntilExit() { kept = true; }

std::vector<DeviceName> ListDevices() {
  std::vector<DeviceName> cameras = Cameras();
  if (cameras.empty()) {
    throw CameraError("no camera found: OpenNI2 sees none; is it plugged in, and listed by lsusb?");
  }
  return cameras;
}

std::string FindDevice(const std::string& wanted) {
  if (IsRecording(wanted)) {
    CheckRecording(wanted);
    return wanted;
  }
  // No camera has the name of a file; this throws, as its name is not that of a recording either.
  if (std::filesystem::is_regular_file(wanted)) CheckRecording(wanted);
  const std::vector<DeviceName> cameras = ListDevices();
  if (wanted.empty()) return cameras.front().uri;
  std::string known;
  for (const auto& [uri, name] : cameras) {
    if (uri == wanted || (wanted.back() == '@' && uri.starts_with(wanted))) return uri;
    known += (known.empty() ? "" : ", ") + uri;
  }
  throw CameraError("no camera " + wanted + " found; plugged in: " + known);
}

std::string NameWithoutPlace(const std::string& uri) {
  const std::size_t at = uri.find('@');
  return at == std::string::npos ? uri : uri.substr(0, at + 1);
}

UnplugWatch::UnplugWatch(std::string uri) : uri_(std::move(uri)) {
  openni::OpenNI::addDeviceDisconnectedListener(this);
}

UnplugWatch::~UnplugWatch() { openni::OpenNI::removeDeviceDisconnectedListener(this); }

void UnplugWatch::onDeviceDisconnected(const openni::DeviceInfo* info) {
  if (info->getUri() == uri_) unplugged_ = true;
}

}  // namespace fovea::capture
