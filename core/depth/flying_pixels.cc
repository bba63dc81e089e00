#include "core/depth/flying_pixels.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/types/interruption.h"
#include "core/types/pixels.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// True where depth rises, or falls, by more than `step` on both sides; false next to NaN.
FOVEA_INLINE bool IsOnRamp(float before, float here, float after, float step) {
  const float rise = here - before, go_on = after - here;
  return ((rise > step) & (go_on > step)) | ((rise < -step) & (go_on < -step));
}

// Of `count` pixels; `before` and `after` point to the neighbours of the first. `slope` is the rise
// to a neighbour as a share of the depth.
void RemoveRamps(const float* before, const float* here, const float* after, int count, float slope,
                 float* out) {
  RunInWidestRegisters([=] {
    for (int i = 0; i < count; ++i) {
      const bool is_flying = IsOnRamp(before[i], here[i], after[i], slope * here[i]);
      out[i] = is_flying ? std::numeric_limits<float>::quiet_NaN() : out[i];
    }
  });
}

}  // namespace

cv::Mat RemoveFlyingPixels(const cv::Mat& depth_m, double fx_px, double fy_px,
                           const FlyingPixelOptions& options) {
  if (options.max_angle_deg >= 90) return depth_m;
  cv::Mat kept = depth_m.clone();
  InterruptionPoint();
  const int stride = ScaledPx(1, depth_m.cols, 1);
  const double slope = std::tan(options.max_angle_deg * std::numbers::pi / 180) * stride;
  const auto slope_x = static_cast<float>(slope / fx_px);
  const auto slope_y = static_cast<float>(slope / fy_px);
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* line = depth_m.ptr<float>(row);
    float* out = kept.ptr<float>(row);
    const float* second = line + stride;
    RemoveRamps(line, second, second + stride, depth_m.cols - 2 * stride, slope_x, out + stride);
    if (row < stride || row >= depth_m.rows - stride) continue;
    RemoveRamps(depth_m.ptr<float>(row - stride), line, depth_m.ptr<float>(row + stride),
                depth_m.cols, slope_y, out);
  }
  return kept;
}

}  // namespace fovea
