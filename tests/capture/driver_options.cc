#include "tests/capture/driver_options.h"

#include <cstdlib>
#include <sstream>

namespace fovea::testing {
namespace {

std::string Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

DriverOptions ReadDriverOptions() {
  DriverOptions options;
  options.frames = Environment("FOVEA_CAMERA_FRAMES");
  options.control = Environment("FOVEA_CAMERA_CONTROL");
  options.fps = std::atoi(Environment("FOVEA_CAMERA_FPS").c_str());
  std::istringstream faults(Environment("FOVEA_CAMERA_FAULTS"));
  for (std::string fault; std::getline(faults, fault, ',');) options.faults.insert(fault);
  return options;
}

}  // namespace fovea::testing
