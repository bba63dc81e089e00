#include "client/cli/intrinsics_flag.h"

#include <filesystem>
#include <stdexcept>

#include "client/cli/calibration_file.h"
#include "client/cli/distortion.h"
#include "client/cli/parsing.h"
#include "client/images.h"

namespace fovea::cli {

namespace fs = std::filesystem;

GivenIntrinsics ReadIntrinsics(const std::string& text, const std::string& flag) {
  std::error_code error;
  if (fs::exists(text, error)) return IntrinsicsInFile(text);
  const auto k = ParseNumbers(text, 4, flag, "FX,FY,CX,CY, and not a file that is there");
  const v1::CameraIntrinsics values = client::MakeIntrinsics(k[0], k[1], k[2], k[3]);
  if (IsCamera(CalibrationOf(values, {}))) return {values, {}, {}};
  throw std::invalid_argument(flag + ": \"" + text +
                              "\": focal lengths must be above 0 and all numbers finite");
}

GivenIntrinsics IntrinsicsInFile(const std::string& path) {
  const Calibration c = ReadCalibration(path);
  return {IntrinsicsOf(c), path, {c.width, c.height}};
}

void SetDistortion(const std::string& flag, v1::CameraIntrinsics* intrinsics) {
  if (flag.empty()) return;
  const auto distortion = ParseDistortion(flag);
  intrinsics->clear_distortion();
  if (distortion) *intrinsics->mutable_distortion() = *distortion;
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
