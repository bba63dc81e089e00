// Which camera, and how it shall deliver.
#pragma once

#include <opencv2/core/types.hpp>
#include <string>

namespace fovea::capture {

enum class CameraKind { kOpenNi, kV4l2 };  // recordings are of OpenNI2

// By its name, CameraOptions.device.
CameraKind KindOf(const std::string& device);

struct CameraOptions {
  std::string device;  // URI, FILE.oni or v4l2:DEPTH,COLOR; empty = the first camera found
  cv::Size size{640, 480};
  cv::Size depth_size;          // of v4l2; empty = that of colour
  double depth_unit_m = 0.001;  // of v4l2
  int fps = 30;
  bool allow_unregistered = false;
  double frame_timeout_s = 5;  // longest time without a frame
  double speed = -1;           // of a recording: 1 = as recorded, -1 = as fast as it is read
};

// "640x480", each 1 to 99999. Throws std::invalid_argument that names the flag.
cv::Size ParseResolution(const std::string& text, const std::string& flag);

}  // namespace fovea::capture
