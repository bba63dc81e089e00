#pragma once

#include <cmath>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// What a calibration says about a camera, in pixels.
struct Calibration {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  int width = 0, height = 0;  // 0 where the file does not say it
  std::optional<v1::LensDistortion> distortion;
};

v1::CameraIntrinsics IntrinsicsOf(const Calibration& calibration);
Calibration CalibrationOf(const v1::CameraIntrinsics& intrinsics, const cv::Size& size);

// Reads, by what is in it, a file of ROS's camera_calibration (YAML: image_width, image_height,
// camera_matrix, distortion_model, distortion_coefficients), a sensor_msgs/CameraInfo as `ros2
// topic echo` prints it or as JSON (width, height, k, distortion_model, d), JSON with fx, fy, cx,
// cy, width and height, and distortion_model and distortion where the lens has some, or the four
// numbers "fx,fy,cx,cy" alone. Throws std::runtime_error that names the file and what is missing or
// impossible in it.
Calibration ReadCalibration(const std::string& path);

// Whether all numbers are finite, and focal lengths above 0.
inline bool IsCamera(const Calibration& c) {
  return std::isfinite(c.fx) && std::isfinite(c.fy) && std::isfinite(c.cx) && std::isfinite(c.cy) &&
         c.fx > 0 && c.fy > 0;
}

// JSON as ReadCalibration reads it.
std::string ToCalibrationJson(const Calibration& calibration);

}  // namespace fovea::cli
