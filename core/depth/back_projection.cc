#include "core/depth/back_projection.h"

#include <limits>
#include <vector>

#include "core/types/interruption.h"

namespace fovea {
namespace {

// What 1 m of depth is across the axis, for each column or row.
std::vector<float> RaysOf(int count, double focal_px, double center_px) {
  std::vector<float> rays(count);
  for (int i = 0; i < count; ++i) rays[i] = static_cast<float>((i - center_px) / focal_px);
  return rays;
}

}  // namespace

cv::Mat BackProject(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics,
                    double max_depth_m) {
  const float limit = static_cast<float>(max_depth_m);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> ray_x = RaysOf(depth_m.cols, intrinsics.fx_px, intrinsics.cx_px);
  const std::vector<float> rays_y = RaysOf(depth_m.rows, intrinsics.fy_px, intrinsics.cy_px);
  cv::Mat points(depth_m.size(), CV_32FC3);
  InterruptionPoint();
  for (int row = 0; row < depth_m.rows; ++row) {
    InterruptionPoint();
    const float ray_y = rays_y[row];
    const float* depth = depth_m.ptr<float>(row);
    cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    for (int col = 0; col < depth_m.cols; ++col) {
      const float z = depth[col] <= limit ? depth[col] : nan;
      point[col] = {z * ray_x[col], z * ray_y, z};
    }
  }
  return points;
}

PixelPoints::PixelPoints(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics)
    : depth_m_(depth_m),
      ray_x_(RaysOf(depth_m.cols, intrinsics.fx_px, intrinsics.cx_px)),
      ray_y_(RaysOf(depth_m.rows, intrinsics.fy_px, intrinsics.cy_px)) {}

}  // namespace fovea
