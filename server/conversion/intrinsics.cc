#include "server/conversion/intrinsics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

LensDistortion::Model ModelFromProto(v1::DistortionModel model, const std::string& path) {
  switch (model) {
    case v1::DISTORTION_MODEL_BROWN_CONRADY:
      return LensDistortion::Model::kBrownConrady;
    case v1::DISTORTION_MODEL_KANNALA_BRANDT:
      return LensDistortion::Model::kKannalaBrandt;
    default:
      FailField(path + ".model",
                std::to_string(model) + " is not one of BROWN_CONRADY, KANNALA_BRANDT");
  }
}

bool IsCount(LensDistortion::Model model, int count) {
  if (model == LensDistortion::Model::kKannalaBrandt) return count == 4;
  return count == 4 || count == 5 || count == 8;
}

LensDistortion FromProto(const v1::LensDistortion& proto, const std::string& path) {
  LensDistortion distortion{ModelFromProto(proto.model(), path), {}};
  const int count = proto.coefficients_size();
  RequireField(IsCount(distortion.model, count), path + ".coefficients",
               "has " + std::to_string(count) +
                   " numbers; KANNALA_BRANDT has 4, BROWN_CONRADY 4, " +
                   "5 or 8: k1, k2, p1, p2, k3, k4, k5, k6");
  std::copy(proto.coefficients().begin(), proto.coefficients().end(),
            distortion.coefficients.begin());
  return distortion;
}

// A fisheye bends rays without any coefficients.
bool IsNone(const LensDistortion& distortion) {
  return distortion.model == LensDistortion::Model::kBrownConrady &&
         std::all_of(distortion.coefficients.begin(), distortion.coefficients.end(),
                     [](double value) { return value == 0; });
}

}  // namespace

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

std::optional<Lens> LensFromProto(const v1::CameraIntrinsics& intrinsics, const cv::Size& size,
                                  const std::string& path) {
  // A camera_info without coefficients is of images that need none, whatever its model.
  if (intrinsics.distortion().coefficients().empty()) return std::nullopt;
  const std::string own = path + ".distortion";
  const LensDistortion distortion = FromProto(intrinsics.distortion(), own);
  if (IsNone(distortion)) return std::nullopt;
  return InField(own + ".coefficients",
                 [&] { return Lens(FromProto(intrinsics, path), distortion, size); });
}

void RequirePlausible(const CameraIntrinsics& intrinsics, const cv::Size& size,
                      const std::string& path) {
  try {
    fovea::RequirePlausible(intrinsics, size);
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();  // "fx: …"
    const std::size_t end = text.find(": ");
    FailField(path + "." + text.substr(0, end), text.substr(end + 2));
  }
}

}  // namespace fovea::server
