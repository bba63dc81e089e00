#include "server/conversion/frame_notes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fovea::server {
namespace {

// How far from the middle of the image, in sizes of it.
struct Offset {
  double x, y;

  double Largest() const { return std::max(std::abs(x), std::abs(y)); }
};

Offset OffsetOf(double cx_px, double cy_px, const cv::Size& size) {
  return {(cx_px - (size.width - 1) / 2.0) / size.width,
          (cy_px - (size.height - 1) / 2.0) / size.height};
}

// In sizes of the image. Beyond 127 degrees nobody rectifies, below 6 nobody looks at a room.
bool IsOddFocalLength(double focal_px, int size_px) {
  return focal_px < size_px / 4.0 || focal_px > size_px * 10.0;
}

}  // namespace

std::optional<std::string> OddIntrinsics(const CameraIntrinsics& k, const cv::Size& size,
                                         const std::string& path) {
  constexpr double kFar = 0.15, kMiddle = 0.05, kMaxRatio = 1.5;
  if (IsOddFocalLength(k.fx_px, size.width) || IsOddFocalLength(k.fy_px, size.height)) {
    return fmt::format(
        "{}: hardly any camera has fx {:g} and fy {:g} with images of {}x{}: they are in pixels of "
        "this image, not in degrees, millimetres or pixels of another size",
        path, k.fx_px, k.fy_px, size.width, size.height);
  }
  const double offset = OffsetOf(k.cx_px, k.cy_px, size).Largest();
  if (offset > 2 * kMiddle && OffsetOf(k.cy_px, k.cx_px, size).Largest() < kMiddle) {
    return fmt::format(
        "{}: cx {:g} and cy {:g} seem to be swapped: the other way round they are the middle of "
        "the image of {}x{}",
        path, k.cx_px, k.cy_px, size.width, size.height);
  }
  if (offset > kFar) {
    return fmt::format(
        "{}: cx {:g}, cy {:g} is far from the middle of the image of {}x{}: unless it is a part of "
        "a larger one, check the order of fx, fy, cx, cy, and for which size they are",
        path, k.cx_px, k.cy_px, size.width, size.height);
  }
  if (std::max(k.fx_px / k.fy_px, k.fy_px / k.fx_px) > kMaxRatio) {
    return fmt::format(
        "{}: fx {:g} and fy {:g} are not alike, as if pixels were not square: unless images were "
        "stretched, check the order of fx, fy, cx, cy",
        path, k.fx_px, k.fy_px);
  }
  return std::nullopt;
}

std::optional<std::string> OddCameraPose(const v1::Frame& frame, const Detections& detections) {
  constexpr double kAxis = 0.94, kDown = 0.99;  // cosines of 20 and 8 degrees
  const Gravity& gravity = detections.gravity;
  const bool is_known = gravity.source == Gravity::Source::kGiven || detections.support;
  if (!frame.has_camera_pose() || !is_known) return std::nullopt;
  const Eigen::Vector3d down = gravity.direction.cast<double>();
  const auto& q = frame.camera_pose().orientation();
  const Eigen::Quaterniond sent = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized();
  const Eigen::Vector3d there = sent * down;
  // Not every frame has its z axis up, but nearly all have one along gravity.
  if (there.cwiseAbs().maxCoeff() > kAxis) return std::nullopt;
  const auto says = [&](const Eigen::Vector3d& otherwise, const char* how) {
    return -otherwise.z() < kDown
               ? std::nullopt
               : std::optional(fmt::format(
                     "frame.camera_pose: gravity is ({:.2f}, {:.2f}, {:.2f}) in its frame, and "
                     "would point down the z axis if the pose were {}: it must be that of the "
                     "optical frame (x right, y down, z forward), with an orientation x, y, z, w",
                     there.x(), there.y(), there.z(), how));
  };
  const Eigen::Quaterniond reordered = Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()).normalized();
  if (auto note = says(reordered * down, "read as w, x, y, z")) return note;
  if (auto note = says(sent.conjugate() * down, "inverted")) return note;
  const Eigen::Vector3d in_body(down.z(), -down.x(), -down.y());
  return says(sent * in_body, "taken for that of the camera's body (x forward, z up)");
}

}  // namespace fovea::server
