// An OpenNI2 driver whose camera serves pictures from a folder: see driver_options.h.
#include <cstring>
#include <filesystem>
#include <thread>

#include "tests/capture/driver_device.h"
#include "tests/capture/driver_options.h"

// What ONI_EXPORT_DRIVER needs, and OpenNI2 does not ship.
#define XN_NEW(type, ...) new type(__VA_ARGS__)
#define XN_DELETE(pointer) delete (pointer)

namespace fovea::testing {
namespace {

OniDeviceInfo Info() {
  OniDeviceInfo info{};
  std::strncpy(info.uri, "fovea/test@0/1", ONI_MAX_STR - 1);
  std::strncpy(info.vendor, "Fovea", ONI_MAX_STR - 1);
  std::strncpy(info.name, "Test camera", ONI_MAX_STR - 1);
  return info;
}

}  // namespace

class Driver : public oni::driver::DriverBase {
 public:
  explicit Driver(OniDriverServices* services) : DriverBase(services) {}

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback state_changed,
                       void* cookie) override {
    DriverBase::initialize(connected, disconnected, state_changed, cookie);
    if (options_.Has("no-device")) return ONI_STATUS_OK;
    deviceConnected(&info_);
    if (!options_.control.empty()) {
      cable_ = std::jthread([this](const std::stop_token& stop) { WatchCable(stop); });
    }
    return ONI_STATUS_OK;
  }

  oni::driver::DeviceBase* deviceOpen(const char*, const char*) override {
    if (options_.Has("denied")) {
      getServices().errorLoggerAppend("Could not open the USB device: access denied");
      return nullptr;
    }
    return new DriverDevice(options_, ++num_openings_);
  }

  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }

  void shutdown() override { cable_ = {}; }

 private:
  // Nobody tells a driver about a file: it has to look again and again.
  void WatchCable(const std::stop_token& stop) {
    for (bool plugged = true; !stop.stop_requested();) {
      if (std::filesystem::exists(options_.control) == plugged) {
        plugged = !plugged;
        plugged ? deviceConnected(&info_) : deviceDisconnected(&info_);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  const DriverOptions options_ = ReadDriverOptions();
  const OniDeviceInfo info_ = Info();
  int num_openings_ = 0;
  std::jthread cable_;
};

}  // namespace fovea::testing

ONI_EXPORT_DRIVER(fovea::testing::Driver)
