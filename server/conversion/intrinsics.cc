#include "server/conversion/intrinsics.h"

#include <cmath>
#include <stdexcept>

#include "server/conversion/field_error.h"

namespace fovea::server {

CameraIntrinsics FromProto(const v1::CameraIntrinsics& intrinsics, const std::string& path) {
  const auto positive = [&](double value, const char* name) {
    RequireField(std::isfinite(value) && value > 0, path + "." + name,
                 std::to_string(value) + " is not a finite positive number of pixels");
    return value;
  };
  const auto finite = [&](double value, const char* name) {
    RequireField(std::isfinite(value), path + "." + name,
                 std::to_string(value) + " is not a finite number of pixels");
    return value;
  };
  return {.fx_px = positive(intrinsics.fx(), "fx"),
          .fy_px = positive(intrinsics.fy(), "fy"),
          .cx_px = finite(intrinsics.cx(), "cx"),
          .cy_px = finite(intrinsics.cy(), "cy")};
}

void RequirePlausible(const CameraIntrinsics& intrinsics, const cv::Size& size,
                      const std::string& path) {
  try {
    fovea::RequirePlausible(intrinsics, size);
  } catch (const std::invalid_argument& error) {
    throw FieldError(path + "." + error.what());
  }
}

}  // namespace fovea::server
