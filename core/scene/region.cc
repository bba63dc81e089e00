#include "core/scene/region.h"

#include <fmt/format.h>

#include <stdexcept>

#include "core/types/projection.h"

namespace fovea {
namespace {

void RequireLess(double first, double second, const char* text) {
  if (!(first < second))
    throw std::invalid_argument(fmt::format(fmt::runtime(text), first, second));
}

}  // namespace

void RequireNotEmpty(const RegionOptions& options, const cv::Size& size) {
  RequireLess(options.x_px, size.width, "region.x_px: {} lies beyond an image {} pixels wide");
  RequireLess(options.y_px, size.height, "region.y_px: {} lies beyond an image {} pixels high");
  RequireLess(options.min_x_m, options.max_x_m, "region.min_x_m: {} is not below max_x_m, {}");
  RequireLess(options.min_y_m, options.max_y_m, "region.min_y_m: {} is not below max_y_m, {}");
  RequireLess(options.min_z_m, options.max_z_m, "region.min_z_m: {} is not below max_z_m, {}");
}

bool IsInRegion(const Eigen::Vector3f& point, const CameraIntrinsics& intrinsics,
                const RegionOptions& options) {
  if (options == RegionOptions()) return true;
  const Eigen::Vector3d p = point.cast<double>();
  const Eigen::Vector3d low(options.min_x_m, options.min_y_m, options.min_z_m);
  const Eigen::Vector3d high(options.max_x_m, options.max_y_m, options.max_z_m);
  if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return false;
  const cv::Point2d pixel = Project(point, intrinsics);
  // Pixel n reaches from n - 0.5 to n + 0.5; its middle may come out a rounding error before n.
  const double u = pixel.x + 0.5 - options.x_px, v = pixel.y + 0.5 - options.y_px;
  return u >= 0 && v >= 0 && (options.width_px == 0 || u < options.width_px) &&
         (options.height_px == 0 || v < options.height_px);
}

}  // namespace fovea
