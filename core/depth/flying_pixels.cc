#include "core/depth/flying_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/types/pixels.h"

namespace fovea {
namespace {

// True where depth rises, or falls, by more than `step` on both sides; false next to NaN.
bool IsOnRamp(float before, float here, float after, float step) {
  const float rise = here - before, go_on = after - here;
  return ((rise > step) & (go_on > step)) | ((rise < -step) & (go_on < -step));
}

}  // namespace

cv::Mat RemoveFlyingPixels(const cv::Mat& depth_m, double fx_px, double fy_px,
                           const FlyingPixelOptions& options) {
  cv::Mat kept = depth_m.clone();
  if (options.max_angle_deg >= 90) return kept;
  const int stride = ScaledPx(1, depth_m.cols, 1);
  const double slope = std::tan(options.max_angle_deg * std::numbers::pi / 180) * stride;
  const auto step_x = static_cast<float>(slope / fx_px), step_y = static_cast<float>(slope / fy_px);
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* above = depth_m.ptr<float>(std::max(0, row - stride));
    const float* line = depth_m.ptr<float>(row);
    const float* below = depth_m.ptr<float>(std::min(depth_m.rows - 1, row + stride));
    float* out = kept.ptr<float>(row);
    for (int col = 0; col < depth_m.cols; ++col) {
      const float left = line[std::max(0, col - stride)];
      const float right = line[std::min(depth_m.cols - 1, col + stride)];
      const float z = line[col];
      if (IsOnRamp(left, z, right, step_x * z) || IsOnRamp(above[col], z, below[col], step_y * z)) {
        out[col] = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return kept;
}

}  // namespace fovea
