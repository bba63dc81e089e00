#include "core/scene/surface_scatter.h"

#include <algorithm>
#include <cstddef>

#include "core/types/interruption.h"

namespace fovea {

float ToleranceShare(const std::vector<Eigen::Vector3f>& points, const SupportSurface& surface,
                     const SupportOptions& options) {
  constexpr float kMinShare = 0.35F;
  constexpr float kMaxShare = 2.5F;
  constexpr float kMedianPerSigma = 0.6745F;  // of the absolute values of a normal distribution
  if (options.tolerance_sigmas <= 0) return 1;
  std::vector<float> depths;  // only below the surface: above it there are low objects as well
  depths.reserve(points.size());
  InterruptionPoint();
  for (const Eigen::Vector3f& p : points) {
    const float depth_m = -surface.HeightOf(p);
    if (depth_m > 0) depths.push_back(depth_m / SupportTolerance(p.z(), options));
  }
  if (depths.empty()) return 1;
  InterruptionPoint();
  const auto median = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), median, depths.end());
  const float sigma = *median / kMedianPerSigma;
  return std::clamp(static_cast<float>(options.tolerance_sigmas) * sigma, kMinShare, kMaxShare);
}

}  // namespace fovea
