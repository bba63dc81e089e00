#include "client/capture/intrinsics.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "client/cli/calibration_file.h"
#include "client/cli/distortion.h"
#include "client/cli/files.h"
#include "client/images.h"

namespace fovea::capture {
namespace {

std::string Text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

bool IsAngle(double rad) { return rad > 0 && rad < std::numbers::pi; }

ChosenIntrinsics Choose(const KnownIntrinsics& known, const FieldOfView& view,
                        const cv::Size& size) {
  if (known.camera) {
    RequireSize(known, size);
    const std::string& path = known.camera->path;
    return {known.camera->values,
            path.empty() ? "as given by --intrinsics" : "from the calibration file " + path, ""};
  }
  if (!IsAngle(view.horizontal_rad) || !IsAngle(view.vertical_rad)) {
    throw NoIntrinsics(
        "the camera does not state its field of view: give --calibration or --intrinsics");
  }
  return {FromFieldOfView(view, size), "from the field of view that the camera states",
          "a calibration is more exact than the field of view: --calibration FILE"};
}

}  // namespace

v1::CameraIntrinsics FromFieldOfView(const FieldOfView& view, const cv::Size& size) {
  // The centre of the first pixel is 0, so the image reaches from -0.5 to width - 0.5.
  return client::MakeIntrinsics(size.width / 2.0 / std::tan(view.horizontal_rad / 2),
                                size.height / 2.0 / std::tan(view.vertical_rad / 2),
                                (size.width - 1) / 2.0, (size.height - 1) / 2.0);
}

KnownIntrinsics ReadIntrinsics(const IntrinsicsFlags& flags) {
  if (!flags.distortion.empty()) cli::ParseDistortion(flags.distortion);
  KnownIntrinsics known{.camera = std::nullopt, .distortion = flags.distortion};
  if (!flags.calibration_path.empty()) {
    known.camera = cli::IntrinsicsInFile(flags.calibration_path);
  }
  if (!flags.numbers_or_file.empty()) {
    known.camera = cli::ReadIntrinsics(flags.numbers_or_file, "--intrinsics");
  }
  return known;
}

void RequireSize(const KnownIntrinsics& known, const cv::Size& size) {
  if (!known.camera || known.camera->size.empty() || known.camera->size == size) return;
  const cv::Size& other = known.camera->size;
  throw std::runtime_error("calibration file " + known.camera->path + ": it is for " +
                           Text(other.width, other.height) + ", the camera sends " +
                           Text(size.width, size.height));
}

ChosenIntrinsics ChooseIntrinsics(const KnownIntrinsics& known, const FieldOfView& view,
                                  const cv::Size& size) {
  ChosenIntrinsics chosen = Choose(known, view, size);
  cli::SetDistortion(known.distortion, &chosen.values);
  return chosen;
}

void SaveIntrinsics(const std::string& path, const v1::CameraIntrinsics& k, const cv::Size& size) {
  cli::WriteFile(path, cli::ToCalibrationJson(cli::CalibrationOf(k, size)));
}

std::string IntrinsicsPathOf(const std::string& recording) {
  return std::filesystem::path(recording).replace_extension(".intrinsics.json").string();
}

std::string Describe(const ChosenIntrinsics& intrinsics) {
  const v1::CameraIntrinsics& k = intrinsics.values;
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "fx %.1f, fy %.1f, cx %.1f, cy %.1f, ", k.fx(), k.fy(),
                k.cx(), k.cy());
  const std::string lens =
      k.has_distortion() ? cli::ModelName(k.distortion()) + " distortion, " : "";
  return numbers + lens + intrinsics.source;
}

}  // namespace fovea::capture
