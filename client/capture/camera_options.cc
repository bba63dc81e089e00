#include "client/capture/camera_options.h"

#include <regex>
#include <stdexcept>

namespace fovea::capture {

CameraKind KindOf(const std::string& device) {
  return device.starts_with("v4l2:") ? CameraKind::kV4l2 : CameraKind::kOpenNi;
}

cv::Size ParseResolution(const std::string& text, const std::string& flag) {
  std::smatch parts;
  if (!std::regex_match(text, parts, std::regex("0*([1-9][0-9]{0,4})x0*([1-9][0-9]{0,4})"))) {
    throw std::invalid_argument(flag + ": \"" + text +
                                "\" is not WIDTHxHEIGHT in pixels, such as 640x480");
  }
  return {std::stoi(parts[1]), std::stoi(parts[2])};
}

}  // namespace fovea::capture
