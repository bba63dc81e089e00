#include "client/capture/devices_command.h"

#include <cstdlib>
#include <iostream>
#include <string>

#include "client/capture/camera_error.h"
#include "client/capture/devices.h"
#include "client/capture/openni_setup.h"

namespace fovea::capture {
namespace {

// "640x480 at 30, …", or why they are not known.
std::string ModesAt(const std::string& uri) {
  openni::Device device;
  if (device.open(uri.c_str()) != openni::STATUS_OK) return "does not open: " + OpenNiReason();
  Streams streams;
  try {
    CreateStreams(device, streams);
    return CommonModes(streams);
  } catch (const CameraError& error) {
    return error.what();
  }
}

}  // namespace

int RunDevices() {
  const OpenNiRuntime runtime;
  for (const DeviceName& device : ListDevices()) {
    std::cout << device.uri << "  " << device.name << "  " << ModesAt(device.uri) << '\n';
  }
  return EXIT_SUCCESS;
}

}  // namespace fovea::capture
