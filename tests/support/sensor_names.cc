#include "tests/support/sensor_names.h"

namespace fovea::scenes {

const std::map<std::string, SensorKind>& SensorsByName() {
  static const std::map<std::string, SensorKind> sensors = {
      {"ideal", SensorKind::kIdeal},
      {"kinect", SensorKind::kKinect},
      {"realsense", SensorKind::kRealSense},
      {"halo_stereo", SensorKind::kHaloStereo}};
  return sensors;
}

}  // namespace fovea::scenes
