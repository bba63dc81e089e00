#include "core/depth/back_projection.h"

#include <limits>
#include <vector>

#include "core/types/interruption.h"

namespace fovea {

cv::Mat BackProject(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics,
                    double max_depth_m) {
  const float limit = static_cast<float>(max_depth_m);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> ray_x(depth_m.cols);
  for (int col = 0; col < depth_m.cols; ++col) {
    ray_x[col] = static_cast<float>((col - intrinsics.cx_px) / intrinsics.fx_px);
  }

  cv::Mat points(depth_m.size(), CV_32FC3);
  InterruptionPoint();
  for (int row = 0; row < depth_m.rows; ++row) {
    InterruptionPoint();
    const float ray_y = static_cast<float>((row - intrinsics.cy_px) / intrinsics.fy_px);
    const float* depth = depth_m.ptr<float>(row);
    cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    for (int col = 0; col < depth_m.cols; ++col) {
      const float z = depth[col] <= limit ? depth[col] : nan;
      point[col] = {z * ray_x[col], z * ray_y, z};
    }
  }
  return points;
}

}  // namespace fovea
