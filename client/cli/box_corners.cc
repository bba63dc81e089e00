#include "client/cli/box_corners.h"

namespace fovea::cli {
namespace {

// q * v * q^-1 for a unit quaternion.
cv::Vec3d Rotate(const v1::Quaternion& q, const cv::Vec3d& v) {
  const cv::Vec3d axis(q.x(), q.y(), q.z());
  const cv::Vec3d t = 2 * axis.cross(v);
  return v + q.w() * t + axis.cross(t);
}

}  // namespace

std::array<cv::Vec3d, 8> CornersOf(const v1::OrientedBox& box) {
  const auto& at = box.pose().position();
  const cv::Vec3d center(at.x(), at.y(), at.z());
  std::array<cv::Vec3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Vec3d offset((i & 1 ? 0.5 : -0.5) * box.size().x(),
                           (i & 2 ? 0.5 : -0.5) * box.size().y(),
                           (i & 4 ? 0.5 : -0.5) * box.size().z());
    corners[i] = center + Rotate(box.pose().orientation(), offset);
  }
  return corners;
}

}  // namespace fovea::cli
