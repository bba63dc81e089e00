// Which devices OpenNI2 sees.
#pragma once

#include <OpenNI.h>

#include <atomic>
#include <string>
#include <vector>

namespace fovea::capture {

// OpenNI2 and its drivers, from construction to destruction. One at a time.
class OpenNiRuntime {
 public:
  OpenNiRuntime();  // throws CameraError
  ~OpenNiRuntime();

  // What is open stays so, whoever ends the runtime.
  static void KeepUntilExit();

  OpenNiRuntime(const OpenNiRuntime&) = delete;
  OpenNiRuntime& operator=(const OpenNiRuntime&) = delete;
};

struct DeviceName {
  std::string uri, name;  // name: "PrimeSense, PS1080"
};

// The cameras that are plugged in. Throws CameraError where there is none.
std::vector<DeviceName> ListDevices();

// The URI to open: `wanted` where it is a recording or plugged in, or the first camera for "". A
// name that ends in "@" stands for that kind of camera at any place. Throws CameraError that names
// what is there.
std::string FindDevice(const std::string& wanted);

// How to find the device again: a USB camera gets another URI each time that it is plugged in.
std::string NameWithoutPlace(const std::string& uri);

// Notices that a device was unplugged.
class UnplugWatch : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  explicit UnplugWatch(std::string uri);
  ~UnplugWatch() override;

  bool Unplugged() const { return unplugged_; }
  void onDeviceDisconnected(const openni::DeviceInfo* info) override;  // NOLINT: OpenNI2's name

 private:
  const std::string uri_;
  std::atomic<bool> unplugged_ = false;
};

}  // namespace fovea::capture
