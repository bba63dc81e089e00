#include "client/cli/intrinsics_flag.h"

#include <filesystem>
#include <stdexcept>

#include "client/cli/calibration_file.h"
#include "client/cli/parsing.h"
#include "client/images.h"

namespace fovea::cli {

namespace fs = std::filesystem;

GivenIntrinsics ReadIntrinsics(const std::string& text, const std::string& flag) {
  std::error_code error;
  if (fs::exists(text, error)) {
    const Calibration c = ReadCalibration(text);
    return {client::MakeIntrinsics(c.fx, c.fy, c.cx, c.cy), text, {c.width, c.height}, c.distorted};
  }
  const auto k = ParseNumbers(text, 4, flag, "FX,FY,CX,CY, and not a file that is there");
  return {client::MakeIntrinsics(k[0], k[1], k[2], k[3]), {}, {}, false};
}

std::string CalibrationIn(const std::string& folder) {
  for (const char* name : {"intrinsics.json", "camera_info.yaml", "intrinsics.txt"}) {
    const fs::path path = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_regular_file(path, error)) return path.string();
  }
  return {};
}

}  // namespace fovea::cli
