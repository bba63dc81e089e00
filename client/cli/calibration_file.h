#pragma once

#include <string>

namespace fovea::cli {

// What a calibration says about a pinhole camera, in pixels.
struct Calibration {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  int width = 0, height = 0;  // 0 where the file does not say it
  bool distorted = false;     // it has distortion coefficients that are not zero
};

// Reads, by what is in it, a file of ROS's camera_calibration (YAML: image_width, image_height,
// camera_matrix, distortion_coefficients), a sensor_msgs/CameraInfo as `ros2 topic echo` prints it
// (YAML: width, height, k, d), JSON with fx, fy, cx, cy, width and height, or the four numbers
// "fx,fy,cx,cy" alone. Throws std::runtime_error that names the file and what is missing or
// impossible in it.
Calibration ReadCalibration(const std::string& path);

// JSON as ReadCalibration reads it.
std::string ToCalibrationJson(const Calibration& calibration);

}  // namespace fovea::cli
