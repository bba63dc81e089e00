#include "core/scene/support_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

#include "core/scene/level_fit.h"
#include "core/scene/surface_scatter.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

Eigen::Vector3f ToEigen(const cv::Vec3f& v) { return {v[0], v[1], v[2]}; }

struct LevelPoints {
  std::vector<Eigen::Vector3f> points;  // those whose normal is about vertical
  std::size_t num_normals = 0;          // of all directions
};

LevelPoints FindLevelPoints(const cv::Mat& points, const NormalMap& normals,
                            const Eigen::Vector3f& up, double max_angle_deg) {
  const float min_cos = static_cast<float>(std::cos(max_angle_deg * std::numbers::pi / 180));
  LevelPoints level;
  level.points.reserve(normals.vectors.total());
  const int step = normals.step_px;
  for (int row = 0; row < normals.vectors.rows; ++row) {
    InterruptionPoint();
    const cv::Vec3f* normal = normals.vectors.ptr<cv::Vec3f>(row);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row * step);
    for (int col = 0; col < normals.vectors.cols; ++col) {
      if (std::isnan(normal[col][0])) continue;
      ++level.num_normals;
      if (ToEigen(normal[col]).dot(up) > min_cos)
        level.points.push_back(ToEigen(point[std::ptrdiff_t{col} * step]));
    }
  }
  return level;
}

// Every few pixels: enough for the cells of a footprint.
std::vector<Eigen::Vector3f> PointsAbove(const cv::Mat& points, const SupportSurface& surface,
                                         const SupportOptions& options, float tolerance_share) {
  constexpr int kStep_px = 4;
  const auto max_height_m = static_cast<float>(options.max_height_m);
  std::vector<Eigen::Vector3f> above;
  above.reserve(points.total() / kStep_px / kStep_px);
  for (int row = 0; row < points.rows; row += kStep_px) {
    InterruptionPoint();
    for (int col = 0; col < points.cols; col += kStep_px) {
      const Eigen::Vector3f point = ToEigen(points.at<cv::Vec3f>(row, col));
      const float height_m = surface.HeightOf(point);  // NaN where there is no point
      const float begin_m = tolerance_share * SupportTolerance(point.z(), options);
      if (height_m > begin_m && height_m < max_height_m) {
        above.push_back(point);
      }
    }
  }
  return above;
}

// Of the points near the surface, those on which nothing can be told to stand.
std::vector<Eigen::Vector3f> PointsOn(const std::vector<Eigen::Vector3f>& inliers,
                                      const SupportSurface& surface, const SupportOptions& options,
                                      float tolerance_share) {
  InterruptionPoint();
  std::vector<Eigen::Vector3f> on;
  on.reserve(inliers.size());
  std::copy_if(inliers.begin(), inliers.end(), std::back_inserter(on), [&](const auto& p) {
    return surface.HeightOf(p) <= tolerance_share * SupportTolerance(p.z(), options);
  });
  return on;
}

Footprint FootprintOf(const std::vector<Eigen::Vector3f>& inliers, const cv::Mat& points,
                      const SupportSurface& surface, const SupportOptions& options,
                      float tolerance_share) {
  const bool matters = options.min_area_m2 > 0 || options.footprint_margin_m > 0;
  InterruptionPoint();
  if (!matters) return {};
  const std::vector<Eigen::Vector3f> on = PointsOn(inliers, surface, options, tolerance_share);
  if (on.empty()) return {};
  return {on, PointsAbove(points, surface, options, tolerance_share), surface, options.min_area_m2,
          options.footprint_margin_m};
}

// Most of the points lie closely above one of the supports.
bool IsCloselyAbove(const std::vector<Support>& supports,
                    const std::vector<Eigen::Vector3f>& points, double max_step_m) {
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    InterruptionPoint();
    const auto above = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
      const float height = support.surface.HeightOf(p);
      return height > 0 && height < max_step_m && support.footprint.Covers(p);
    });
    return 2 * static_cast<std::size_t>(above) > points.size();
  });
}

// Surfaces in the height of objects above another one are mostly the tops of objects, also of
// several side by side.
double MinArea_m2(const std::vector<Support>& supports, const std::vector<Eigen::Vector3f>& points,
                  const SupportOptions& options) {
  constexpr double kObjectHeight_m = 0.4;
  constexpr double kObjectTops = 4;
  return IsCloselyAbove(supports, points, kObjectHeight_m) ? kObjectTops * options.min_area_m2
                                                           : options.min_area_m2;
}

// None if too little of the surface is seen; or nothing, where most heights lie beside its
// tolerance.
std::optional<Support> SupportOn(const SupportSurface& surface,
                                 const std::vector<Eigen::Vector3f>& inliers, const cv::Mat& points,
                                 const std::vector<Support>& others,
                                 const SupportOptions& options) {
  if (inliers.empty()) return std::nullopt;
  const double min_area_m2 = MinArea_m2(others, inliers, options);
  if (Footprint::LargestAreaM2(inliers, surface) < min_area_m2) return std::nullopt;
  const float tolerance_share = ToleranceShare(inliers, surface, options);
  const Footprint footprint = FootprintOf(inliers, points, surface, options, tolerance_share);
  InterruptionPoint();
  if (footprint.AreaM2() < min_area_m2) return std::nullopt;
  return Support{surface, options.footprint_margin_m > 0 ? footprint : Footprint(),
                 tolerance_share};
}

// Takes the points of a surface out, with what noise left around it. False if there were none.
bool RemoveInliers(std::vector<Eigen::Vector3f>& level, const SupportSurface& surface,
                   const SupportOptions& options) {
  LongLoop loop;
  const auto removed = std::remove_if(level.begin(), level.end(), [&](const Eigen::Vector3f& p) {
    loop.Turn();
    return std::abs(surface.HeightOf(p)) <= 2 * SupportTolerance(p.z(), options);
  });
  const bool any = removed != level.end();
  level.erase(removed, level.end());
  return any;
}

}  // namespace

float SupportTolerance(float z_m, const SupportOptions& options) {
  return static_cast<float>(options.tolerance_m) +
         static_cast<float>(options.tolerance_per_m) * z_m * z_m;
}

std::vector<Support> FindSupports(const cv::Mat& points, const NormalMap& normals,
                                  const Eigen::Vector3f& gravity, const SupportOptions& options) {
  Eigen::Vector3f up = -gravity;
  auto [level, num_normals] = FindLevelPoints(points, normals, up, options.max_angle_deg);
  const auto min_points = static_cast<std::size_t>(
      std::max(3.0, std::ceil(options.min_share * static_cast<double>(num_normals))));

  std::vector<Support> supports;
  for (int attempt = 0; attempt < 3 * options.max_surfaces; ++attempt) {
    InterruptionPoint();
    if (level.size() < 3) break;
    const SupportSurface surface = FitLevelSurface(level, up, options);
    const std::vector<Eigen::Vector3f> inliers = PointsNear(level, surface, options);
    InterruptionPoint();
    if (supports.empty() && inliers.size() < min_points) break;
    if (const auto support = SupportOn(surface, inliers, points, supports, options)) {
      if (options.max_surfaces > 1 && supports.empty()) up = surface.normal;  // the better vertical
      supports.push_back(*support);
      if (static_cast<int>(supports.size()) == options.max_surfaces) break;
    }
    if (!RemoveInliers(level, surface, options)) break;
  }
  return supports;
}

void RefitSurfaces(const std::vector<Eigen::Vector3f>& points, const SupportOptions& options,
                   std::vector<Support>& supports) {
  std::vector<Eigen::Vector3f> covered;
  covered.reserve(points.size());
  for (Support& support : supports) {
    InterruptionPoint();
    covered.clear();
    std::copy_if(points.begin(), points.end(), std::back_inserter(covered),
                 [&](const auto& p) { return support.footprint.Covers(p); });
    support.surface = FitAnew(covered, support.surface, options);
  }
}

std::optional<std::size_t> SupportBelow(const std::vector<Support>& supports,
                                        const Eigen::Vector3f& point,
                                        const SupportOptions& options) {
  const float tolerance = SupportTolerance(point.z(), options);
  float nearest = static_cast<float>(options.max_height_m);
  std::optional<std::size_t> below;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const float height = supports[i].surface.HeightOf(point);
    const float depth = -supports[i].LargestShare() * tolerance;
    if (height < depth || height > nearest || !supports[i].footprint.Covers(point)) continue;
    if (height <= supports[i].tolerance_share * tolerance) return std::nullopt;
    nearest = height;
    below = i;
  }
  return below;
}

bool IsOnSupport(const std::vector<Support>& supports, const Eigen::Vector3f& point,
                 const SupportOptions& options) {
  const float tolerance = SupportTolerance(point.z(), options);
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    return std::abs(support.surface.HeightOf(point)) <= support.LargestShare() * tolerance &&
           support.footprint.Covers(point);
  });
}

}  // namespace fovea
