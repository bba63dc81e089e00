#include "core/scene/support_surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

namespace fovea {
namespace {

Eigen::Vector3f ToEigen(const cv::Vec3f& v) { return {v[0], v[1], v[2]}; }

// The points whose normal is about vertical.
std::vector<Eigen::Vector3f> LevelPoints(const cv::Mat& points, const cv::Mat& normals,
                                         const Eigen::Vector3f& up, double max_angle_deg) {
  const float min_cos = static_cast<float>(std::cos(max_angle_deg * std::numbers::pi / 180));
  std::vector<Eigen::Vector3f> level;
  for (int row = 0; row < points.rows; ++row) {
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    const cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row);
    for (int col = 0; col < points.cols; ++col) {
      if (ToEigen(normal[col]).dot(up) > min_cos) level.push_back(ToEigen(point[col]));
    }
  }
  return level;
}

// Middle of the fullest interval; the lowest of equals.
float DominatingHeight(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up,
                       float bin) {
  std::map<int, std::size_t> histogram;
  for (const Eigen::Vector3f& p : points)
    ++histogram[static_cast<int>(std::floor(up.dot(p) / bin))];
  // Neighbouring bins count half, so that a surface that straddles a border is not missed.
  int best_bin = 0;
  std::size_t best_count = 0;
  for (const auto& [index, count] : histogram) {
    const auto below = histogram.find(index - 1);
    const auto above = histogram.find(index + 1);
    const std::size_t smoothed = 2 * count + (below == histogram.end() ? 0 : below->second) +
                                 (above == histogram.end() ? 0 : above->second);
    if (smoothed > best_count) {
      best_count = smoothed;
      best_bin = index;
    }
  }
  return (static_cast<float>(best_bin) + 0.5F) * bin;
}

std::vector<Eigen::Vector3f> Inliers(const std::vector<Eigen::Vector3f>& points,
                                     const SupportSurface& surface, const SupportOptions& options,
                                     float widening) {
  std::vector<Eigen::Vector3f> inliers;
  for (const Eigen::Vector3f& p : points) {
    if (std::abs(surface.HeightOf(p)) <= widening * SupportTolerance(p.z(), options)) {
      inliers.push_back(p);
    }
  }
  return inliers;
}

// Least-squares plane; each point weighs 1/z⁴, the inverse variance of structured-light depth.
SupportSurface FitPlane(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double total = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    const double weight = 1 / std::max(1e-4, p.z() * p.z() * p.z() * p.z());
    total += weight;
    mean += weight * p;
    moments += weight * p * p.transpose();
  }
  mean /= total;
  const Eigen::Matrix3d covariance = moments / total - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(up.cast<double>()) < 0) normal = -normal;
  return {normal.cast<float>(), static_cast<float>(-normal.dot(mean)), points.size()};
}

}  // namespace

float SupportTolerance(float z_m, const SupportOptions& options) {
  return static_cast<float>(options.tolerance_m) +
         static_cast<float>(options.tolerance_per_m) * z_m * z_m;
}

std::optional<SupportSurface> FindSupportSurface(const cv::Mat& points, const cv::Mat& normals,
                                                 const Eigen::Vector3f& gravity,
                                                 const SupportOptions& options) {
  const Eigen::Vector3f up = -gravity;
  const std::vector<Eigen::Vector3f> level =
      LevelPoints(points, normals, up, options.max_angle_deg);
  if (level.empty()) return std::nullopt;

  const float height = DominatingHeight(level, up, static_cast<float>(options.height_bin_m));
  SupportSurface surface{up, -height, 0};
  for (int fit = 0; fit < options.plane_fits; ++fit) {
    const float widening = fit == 0 ? 2.0F : 1.0F;  // gravity may be off by a degree at first
    const std::vector<Eigen::Vector3f> inliers = Inliers(level, surface, options, widening);
    if (inliers.size() < 3) break;
    surface = FitPlane(inliers, up);
  }
  surface.num_points = Inliers(level, surface, options, 1.0F).size();

  const int measured =
      cv::countNonZero(cv::Mat(points.reshape(1, points.rows * points.cols).col(2) > 0));
  if (static_cast<double>(surface.num_points) < options.min_share * measured) return std::nullopt;
  return surface;
}

cv::Mat HeightsAbove(const SupportSurface& surface, const cv::Mat& points) {
  cv::Mat heights(points.size(), CV_32FC1);
  for (int row = 0; row < points.rows; ++row) {
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    float* height = heights.ptr<float>(row);
    for (int col = 0; col < points.cols; ++col) height[col] = surface.HeightOf(ToEigen(point[col]));
  }
  return heights;
}

}  // namespace fovea
