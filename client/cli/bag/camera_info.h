#pragma once

#include <string_view>

#include "client/cli/calibration_file.h"

namespace fovea::cli {

// ROS 2's sensor_msgs/CameraInfo in CDR: of the images as the camera takes them (K and D), or of
// `rectified` ones (P, without distortion), cut out and binned as the message says. Throws
// std::invalid_argument that says what is wrong.
Calibration CameraInfo(std::string_view message, bool rectified);

}  // namespace fovea::cli
