#include "server/conversion/frame.h"

#include <cmath>

#include "server/conversion/field_error.h"
#include "server/conversion/geometry.h"
#include "server/conversion/image.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxIdBytes = 256;

void RequireParts(const v1::Frame& frame) {
  RequireField(frame.id().size() <= kMaxIdBytes, "frame.id",
               "has " + std::to_string(frame.id().size()) + " bytes, at most " +
                   std::to_string(kMaxIdBytes) + " are allowed");
  RequireField(frame.has_color(), "frame.color",
               "is missing; send RGB8 or BGR8 rows, or a JPEG or PNG file");
  RequireField(frame.has_depth(), "frame.depth",
               "is missing; send depth registered to colour, for example 16UC1 in millimetres");
  RequireField(frame.has_intrinsics(), "frame.intrinsics",
               "is missing; send fx, fy, cx, cy of the colour camera in pixels");
}

CameraIntrinsics IntrinsicsFromProto(const v1::CameraIntrinsics& intrinsics) {
  const auto positive = [](double value, const char* name) {
    RequireField(std::isfinite(value) && value > 0, std::string("frame.intrinsics.") + name,
                 std::to_string(value) + " is not a finite positive number of pixels");
    return value;
  };
  const auto finite = [](double value, const char* name) {
    RequireField(std::isfinite(value), std::string("frame.intrinsics.") + name,
                 std::to_string(value) + " is not a finite number of pixels");
    return value;
  };
  return {.fx_px = positive(intrinsics.fx(), "fx"),
          .fy_px = positive(intrinsics.fy(), "fy"),
          .cx_px = finite(intrinsics.cx(), "cx"),
          .cy_px = finite(intrinsics.cy(), "cy")};
}

Eigen::Vector3f GravityFromProto(const v1::Vector3& proto) {
  const Eigen::Vector3d gravity = FromProto(proto);
  const double length = gravity.norm();
  RequireField(std::isfinite(length) && std::abs(length - 1) <= 0.1, "frame.gravity",
               "must be a unit vector that points down; its length is " + std::to_string(length));
  return gravity.normalized().cast<float>();
}

void RequireSameSize(const cv::Mat& color, const cv::Mat& depth) {
  const auto text = [](const cv::Mat& image) {
    return std::to_string(image.cols) + "x" + std::to_string(image.rows);
  };
  RequireField(color.size() == depth.size(), "frame.depth",
               "is " + text(depth) + ", colour is " + text(color) +
                   "; depth must be registered to colour and have its size");
}

}  // namespace

RgbdFrame FromProto(const v1::Frame& frame, std::uint64_t max_pixels) {
  RequireParts(frame);
  RgbdFrame result;
  // What is cheap to check comes before the images.
  result.intrinsics = IntrinsicsFromProto(frame.intrinsics());
  if (frame.has_gravity()) result.gravity = GravityFromProto(frame.gravity());
  if (frame.has_camera_pose()) FromProto(frame.camera_pose(), "frame.camera_pose");

  result.color_rgb = ColorFromProto(frame.color(), max_pixels);
  result.depth_m = DepthFromProto(frame.depth(), max_pixels);
  RequireSameSize(result.color_rgb, result.depth_m);
  return result;
}

}  // namespace fovea::server
