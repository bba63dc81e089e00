#include "core/scene/image_direction.h"

#include <opencv2/core.hpp>

namespace fovea {

std::optional<cv::Point2f> UpInImage(const Eigen::Vector3f& point,
                                     const CameraIntrinsics& intrinsics,
                                     const Eigen::Vector3f& up) {
  constexpr float kMinSlope = 0.3F;  // of up against the viewing ray, as a sine
  const Eigen::Vector3f ray = point.normalized();
  if ((up - up.dot(ray) * ray).norm() < kMinSlope) return std::nullopt;
  const float slope_x = up.x() - up.z() * point.x() / point.z();
  const float slope_y = up.y() - up.z() * point.y() / point.z();
  const cv::Point2f direction(slope_x * static_cast<float>(intrinsics.fx_px),
                              slope_y * static_cast<float>(intrinsics.fy_px));
  return direction / static_cast<float>(cv::norm(direction));
}

}  // namespace fovea
