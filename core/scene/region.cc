#include "core/scene/region.h"

#include "core/types/projection.h"

namespace fovea {

bool IsInRegion(const Eigen::Vector3f& point, const CameraIntrinsics& intrinsics,
                const RegionOptions& options) {
  const Eigen::Vector3d p = point.cast<double>();
  const Eigen::Vector3d low(options.min_x_m, options.min_y_m, options.min_z_m);
  const Eigen::Vector3d high(options.max_x_m, options.max_y_m, options.max_z_m);
  if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return false;
  const cv::Point2d pixel = Project(point, intrinsics);
  const double u = pixel.x - options.x_px, v = pixel.y - options.y_px;
  return u >= 0 && v >= 0 && (options.width_px == 0 || u < options.width_px) &&
         (options.height_px == 0 || v < options.height_px);
}

}  // namespace fovea
