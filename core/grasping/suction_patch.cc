#include "core/grasping/suction_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fovea {
namespace {

// Points of the object within the radius of the middle, of at most some 15 x 15 pixels.
std::vector<Eigen::Vector3f> PointsAround(const GraspScene& scene, int label,
                                          const cv::Point& pixel, const Eigen::Vector3f& middle,
                                          float radius_m) {
  constexpr int kAcross = 15;
  const float reach_px = radius_m * static_cast<float>(scene.intrinsics.fx_px) / middle.z();
  const int reach = std::max(1, static_cast<int>(std::ceil(reach_px)));
  const int step = std::max(1, 2 * reach / kAcross);
  std::vector<Eigen::Vector3f> points;
  for (int row = pixel.y - reach; row <= pixel.y + reach; row += step) {
    for (int column = pixel.x - reach; column <= pixel.x + reach; column += step) {
      if (row < 0 || column < 0 || row >= scene.labels.rows || column >= scene.labels.cols)
        continue;
      if (scene.labels.ptr<std::uint16_t>(row)[column] != label) continue;
      const cv::Vec3f& p = scene.points.ptr<cv::Vec3f>(row)[column];
      const Eigen::Vector3f point(p[0], p[1], p[2]);
      if (!std::isnan(p[2]) && (point - middle).norm() < radius_m) points.push_back(point);
    }
  }
  return points;
}

// Of sixteen parts of a turn, without an arc tangent: the octant, halved.
std::size_t SectorOf(float x, float y) {
  const float a = std::abs(x), b = std::abs(y);
  constexpr std::array kTangents = {0.41421356F, 1.0F, 2.41421356F};
  std::size_t quarter = 0;
  for (const float tangent : kTangents) quarter += b > tangent * a ? 1 : 0;
  return quarter + (x < 0 ? 4U : 0U) + (y < 0 ? 8U : 0U);
}

}  // namespace

std::optional<SuctionPatch> PatchAt(const GraspScene& scene, int label, const cv::Point& pixel,
                                    const Eigen::Vector3f& middle, float diameter_m) {
  constexpr std::size_t kLeastPoints = 8;
  constexpr float kLip = 0.55F;  // of the radius: what lies farther out is under the lip
  if (std::isnan(middle.z())) return std::nullopt;
  // A little farther than the lip, so that an edge just beyond it is seen.
  const float radius = 1.15F * diameter_m / 2;
  const auto points = PointsAround(scene, label, pixel, middle, radius);
  if (points.size() < kLeastPoints) return std::nullopt;

  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point : points) mean += point / static_cast<float>(points.size());
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Eigen::Vector3f& point : points) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes(spread);
  SuctionPatch patch;
  patch.normal = axes.eigenvectors().col(0);
  if (patch.normal.dot(middle) > 0) patch.normal = -patch.normal;
  const Eigen::Vector3f u = axes.eigenvectors().col(2), v = patch.normal.cross(u);

  // height = a + b · squared distance from the middle
  Eigen::Matrix2f sums = Eigen::Matrix2f::Zero();
  Eigen::Vector2f right = Eigen::Vector2f::Zero();
  std::array<bool, 16> is_covered{};
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f from = point - middle;
    const float x = from.dot(u), y = from.dot(v), height = (point - mean).dot(patch.normal);
    const Eigen::Vector2f row(1, (x * x + y * y) / (radius * radius));
    sums += row * row.transpose();
    right += row * height;
    if (std::hypot(x, y) > kLip * radius) is_covered[SectorOf(x, y)] = true;
  }
  sums.diagonal().array() += 1e-3F;
  const Eigen::Vector2f fit = sums.inverse() * right;
  float squares = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f from = point - middle;
    const float height = (point - mean).dot(patch.normal);
    const Eigen::Vector3f level = from - patch.normal * from.dot(patch.normal);
    const float rest = height - fit[0] - fit[1] * level.squaredNorm() / (radius * radius);
    squares += rest * rest;
  }
  patch.unevenness_m = std::sqrt(squares / static_cast<float>(points.size()));
  patch.curvature_per_m = 2 * std::abs(fit[1]) / (radius * radius);
  patch.covered = static_cast<float>(std::count(is_covered.begin(), is_covered.end(), true)) / 16;
  patch.num_points = static_cast<int>(points.size());
  patch.center = middle + patch.normal * (fit[0] - (middle - mean).dot(patch.normal));
  return patch;
}

}  // namespace fovea
