#include "core/scene/level_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_map>

#include "core/scene/plane_fit.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr std::size_t kMinPoints = 3;
constexpr std::size_t kManyPoints = 500;  // tell a plane within a millimetre

// Middle of the fullest interval; the lowest of equals.
float DominatingHeight(const Points& points, const Eigen::Vector3f& up, float bin) {
  InterruptionPoint();
  constexpr std::size_t kUsualBins = 256;
  std::unordered_map<int, std::size_t> histogram(kUsualBins);
  int last_bin = 0;
  std::size_t* count = nullptr;  // of that bin, into which the next point mostly falls, too
  LongLoop loop;
  for (const Eigen::Vector3f& p : points) {
    loop.Turn();
    const int index = static_cast<int>(std::floor(up.dot(p) / bin));
    if (count == nullptr || index != last_bin) count = &histogram[last_bin = index];
    ++*count;
  }
  // Neighbouring bins count half, so that a surface that straddles a border is not missed.
  const auto count_of = [&](int index) {
    const auto found = histogram.find(index);
    return found == histogram.end() ? 0 : found->second;
  };
  int best_bin = 0;
  std::size_t best_count = 0;
  for (const auto& [index, in_bin] : histogram) {
    const std::size_t smoothed = 2 * in_bin + count_of(index - 1) + count_of(index + 1);
    if (smoothed > best_count || (smoothed == best_count && index < best_bin)) {
      best_count = smoothed;
      best_bin = index;
    }
  }
  return (static_cast<float>(best_bin) + 0.5F) * bin;
}

struct Interval {
  float middle = 0;
  float half_width = 0;
};

// The shortest interval that holds half of the values (Rousseeuw 1984); at least one value. Sorts
// them.
Interval ShortestHalf(std::vector<float>& values) {
  InterruptionPoint();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const auto width = [&](std::size_t begin) { return values[begin + half] - values[begin]; };
  std::size_t best = 0;
  for (std::size_t begin = 1; begin + half < values.size(); ++begin) {
    if (width(begin) < width(best)) best = begin;
  }
  return {(values[best] + values[best + half]) / 2, width(best) / 2};
}

void KeepNear(const Points& points, const SupportSurface& surface, const SupportOptions& options,
              float widening, Points& near) {
  near.clear();
  near.reserve(points.size());
  LongLoop loop;
  std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](const auto& p) {
    loop.Turn();
    return std::abs(surface.HeightOf(p)) <= widening * SupportTolerance(p.z(), options);
  });
}

// Every k-th of the points within two tolerances of the surface.
Points SampleNear(const Points& points, const SupportSurface& surface,
                  const SupportOptions& options) {
  Points near = PointsNear(points, surface, options, 2);
  const std::size_t step = (near.size() + kManyPoints - 1) / kManyPoints;
  if (step <= 1) return near;
  for (std::size_t i = 0; i * step < near.size(); ++i) near[i] = near[i * step];
  near.resize((near.size() + step - 1) / step);
  return near;
}

// The heights of points above surfaces, in tolerances. Keeps its memory from one to the next.
class Heights {
 public:
  explicit Heights(const SupportOptions& options) : options_(options) {}

  // Half of how far those of half of the points are apart.
  float Scatter(const Points& points, const SupportSurface& surface) {
    SetHeights(points, surface);
    return ShortestHalf(heights_).half_width;
  }

  // Of the points within the tolerance, those that scatter about the height of most of them. Low
  // things lie within the tolerance as well, but at another height. Until the next call.
  const Points& AtCommonHeight(const Points& points, const SupportSurface& surface) {
    constexpr float kSigmas = 2;
    constexpr float kHalfPerSigma = 0.6745F;  // half of a normal distribution is so near its mean
    KeepNear(points, surface, options_, 1, near_);
    if (near_.empty()) return near_;
    SetHeights(near_, surface);
    sorted_ = heights_;
    const Interval most = ShortestHalf(sorted_);
    const float reach = kSigmas / kHalfPerSigma * most.half_width;
    std::size_t count = 0;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (std::abs(heights_[i] - most.middle) <= reach) near_[count++] = near_[i];
    }
    near_.resize(count);
    return near_;
  }

 private:
  void SetHeights(const Points& points, const SupportSurface& surface) {
    InterruptionPoint();
    heights_.resize(points.size());
    std::transform(points.begin(), points.end(), heights_.begin(), [&](const auto& p) {
      return surface.HeightOf(p) / SupportTolerance(p.z(), options_);
    });
  }

  const SupportOptions& options_;
  Points near_;
  std::vector<float> heights_, sorted_;
};

SupportSurface FitWide(const Points& points, SupportSurface surface, const Eigen::Vector3f& up,
                       const SupportOptions& options) {
  Points inliers;
  for (int fit = 0; fit < options.plane_fits; ++fit) {
    InterruptionPoint();
    const float widening = fit == 0 ? 2.0F : 1.0F;  // gravity may be off by a degree at first
    KeepNear(points, surface, options, widening, inliers);
    if (inliers.size() < kMinPoints) break;
    InterruptionPoint();
    surface = FitPlane(inliers, up);
  }
  return surface;
}

SupportSurface FitToCommonHeight(const Points& points, SupportSurface surface,
                                 const Eigen::Vector3f& up, const SupportOptions& options,
                                 Heights& heights) {
  const Points sample = SampleNear(points, surface, options);
  for (int fit = 0; fit < options.common_height_fits; ++fit) {
    const Points& inliers = heights.AtCommonHeight(sample, surface);
    if (inliers.size() < kMinPoints) break;
    surface = FitPlane(inliers, up);
  }
  return surface;
}

// From two starts, as each may end in a plane through the surface and a low thing on it, and a
// level one may miss what gravity is off. The median of residuals tells.
SupportSurface FitRobustly(const Points& points, const SupportSurface& level,
                           const SupportSurface& wide, const Eigen::Vector3f& up,
                           const SupportOptions& options) {
  const Points sample = SampleNear(points, level, options);
  if (sample.empty()) return wide;
  Heights heights(options);
  constexpr float kBlurred = 0.25F;  // of the tolerance; such noise hides low things anyway
  if (heights.Scatter(sample, wide) > kBlurred) return wide;
  const SupportSurface from_level = FitToCommonHeight(points, level, up, options, heights);
  const SupportSurface from_wide = FitToCommonHeight(points, wide, up, options, heights);
  constexpr float kClearlyLess = 0.8F;
  return heights.Scatter(sample, from_wide) < kClearlyLess * heights.Scatter(sample, from_level)
             ? from_wide
             : from_level;
}

}  // namespace

Points PointsNear(const Points& points, const SupportSurface& surface,
                  const SupportOptions& options, float widening) {
  Points near;
  KeepNear(points, surface, options, widening, near);
  return near;
}

SupportSurface FitLevelSurface(const Points& points, const Eigen::Vector3f& up,
                               const SupportOptions& options) {
  const float height = DominatingHeight(points, up, static_cast<float>(options.height_bin_m));
  const SupportSurface level{up, -height, 0};
  SupportSurface surface = FitWide(points, level, up, options);
  if (options.common_height_fits > 0) surface = FitRobustly(points, level, surface, up, options);
  surface.num_points = PointsNear(points, surface, options).size();
  return surface;
}

SupportSurface FitAnew(const Points& points, const SupportSurface& surface,
                       const SupportOptions& options) {
  constexpr std::size_t kEnoughPoints = 50;
  if (PointsNear(points, surface, options).size() < kEnoughPoints) return surface;
  Heights heights(options);
  SupportSurface anew = FitToCommonHeight(points, surface, surface.normal, options, heights);
  anew.num_points = surface.num_points;
  return anew;
}

}  // namespace fovea
