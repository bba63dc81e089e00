#pragma once

#include <string>

namespace fovea::capture {

// What a calibration says about a pinhole camera, in pixels.
struct Calibration {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  int width = 0, height = 0;
  bool distorted = false;  // it has distortion coefficients that are not zero
};

// Reads a file of ROS's camera_calibration (YAML: image_width, image_height, camera_matrix,
// distortion_coefficients), or JSON with fx, fy, cx, cy, width and height. Throws
// std::runtime_error that names the file and what is missing or impossible in it.
Calibration ReadCalibration(const std::string& path);

}  // namespace fovea::capture
