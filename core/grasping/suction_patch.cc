#include "core/grasping/suction_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace fovea {
namespace {

constexpr int kAcross = 15, kMostPoints = (2 * kAcross - 1) * (2 * kAcross - 1);
using PatchArray = Eigen::Array<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMostPoints, 1>;

// Points of a patch, as seen from its middle.
struct PatchPoints {
  PatchArray x, y, z;

  PatchArray Along(const Eigen::Vector3f& axis) const {
    return axis.x() * x + axis.y() * y + axis.z() * z;
  }
};

// Pixels along one axis of the image: every `step`th, up to `reach` on both sides of the middle.
struct Steps {
  int reach, step;
};

Steps StepsOver(float radius_m, double focal_px, float z_m, const cv::Size& image) {
  const float reach_px = radius_m * static_cast<float>(focal_px) / z_m;
  const auto farthest_px = static_cast<float>(std::max(image.width, image.height));
  const int reach = std::max(1, static_cast<int>(std::ceil(std::min(reach_px, farthest_px))));
  return {reach, std::max(1, 2 * reach / kAcross)};
}

// Of the object, within the radius of the middle, of pixels that are one apart or, where there are
// more than some 15 across, several.
PatchPoints PointsAround(const GraspScene& scene, int label, const cv::Point& pixel,
                         const Eigen::Vector3f& middle, float radius_m) {
  const cv::Rect image({}, scene.labels.size());
  const Steps columns = StepsOver(radius_m, scene.intrinsics.fx_px, middle.z(), image.size());
  const Steps rows = StepsOver(radius_m, scene.intrinsics.fy_px, middle.z(), image.size());
  PatchPoints found{PatchArray(kMostPoints), PatchArray(kMostPoints), PatchArray(kMostPoints)};
  Eigen::Index count = 0;
  for (int row = pixel.y - rows.reach; row <= pixel.y + rows.reach; row += rows.step) {
    if (row < 0 || row >= image.height) continue;
    const auto* labels = scene.labels.ptr<std::uint16_t>(row);
    const auto* points = scene.points.ptr<Eigen::Vector3f>(row);
    for (int column = pixel.x - columns.reach; column <= pixel.x + columns.reach;
         column += columns.step) {
      if (column < 0 || column >= image.width || labels[column] != label) continue;
      const Eigen::Vector3f from = points[column] - middle;
      if (!(from.squaredNorm() < radius_m * radius_m)) continue;  // nor what is not measured
      found.x[count] = from.x();
      found.y[count] = from.y();
      found.z[count++] = from.z();
    }
  }
  for (PatchArray* array : {&found.x, &found.y, &found.z}) array->conservativeResize(count);
  return found;
}

// Sums of products of the coordinates, around their mean.
Eigen::Matrix3f SpreadOf(const PatchPoints& points, const Eigen::Vector3f& mean) {
  const PatchArray x = points.x - mean.x(), y = points.y - mean.y(), z = points.z - mean.z();
  const float xy = (x * y).sum(), xz = (x * z).sum(), yz = (y * z).sum();
  Eigen::Matrix3f spread;
  spread << x.square().sum(), xy, xz, xy, y.square().sum(), yz, xz, yz, z.square().sum();
  return spread;
}

// Of sixteen parts of a turn, without an arc tangent: the octant, halved.
std::size_t SectorOf(float x, float y) {
  const float a = std::abs(x), b = std::abs(y);
  constexpr std::array kTangents = {0.41421356F, 1.0F, 2.41421356F};
  std::size_t quarter = 0;
  for (const float tangent : kTangents) quarter += b > tangent * a ? 1 : 0;
  return quarter + (x < 0 ? 4U : 0U) + (y < 0 ? 8U : 0U);
}

// Of the sixteen sectors, the share with points farther from the middle than `lip_m`.
float CoveredShare(const PatchArray& x, const PatchArray& y, float lip_m) {
  std::array<bool, 16> is_covered{};
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x[i] * x[i] + y[i] * y[i] > lip_m * lip_m) is_covered[SectorOf(x[i], y[i])] = true;
  }
  return static_cast<float>(std::count(is_covered.begin(), is_covered.end(), true)) / 16;
}

}  // namespace

std::optional<SuctionPatch> PatchAt(const GraspScene& scene, int label, const cv::Point& pixel,
                                    const Eigen::Vector3f& middle, float diameter_m) {
  constexpr Eigen::Index kLeastPoints = 8;
  constexpr float kLip = 0.55F;  // of the radius: what lies farther out is under the lip
  if (std::isnan(middle.z())) return std::nullopt;
  // A little farther than the lip, so that an edge just beyond it is seen.
  const float radius = 1.15F * diameter_m / 2;
  const PatchPoints points = PointsAround(scene, label, pixel, middle, radius);
  const Eigen::Index count = points.x.size();
  if (count < kLeastPoints) return std::nullopt;

  const Eigen::Vector3f mean(points.x.mean(), points.y.mean(), points.z.mean());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes(SpreadOf(points, mean));
  SuctionPatch patch;
  patch.normal = axes.eigenvectors().col(0);
  if (patch.normal.dot(middle) > 0) patch.normal = -patch.normal;
  const Eigen::Vector3f u = axes.eigenvectors().col(2), v = patch.normal.cross(u);

  // height over the plane through the middle = a + b · squared distance from the middle
  const PatchArray x = points.Along(u), y = points.Along(v), height = points.Along(patch.normal);
  const PatchArray squared = (x.square() + y.square()) / (radius * radius);
  const float sum = squared.sum();
  Eigen::Matrix2f sums;
  sums << static_cast<float>(count), sum, sum, squared.square().sum();
  sums.diagonal().array() += 1e-3F;
  const Eigen::Vector2f right(height.sum(), (squared * height).sum());
  const Eigen::Vector2f fit = sums.inverse() * right;
  patch.unevenness_m = std::sqrt((height - fit[0] - fit[1] * squared).square().mean());
  patch.curvature_per_m = 2 * std::abs(fit[1]) / (radius * radius);
  patch.covered = CoveredShare(x, y, kLip * radius);
  patch.num_points = static_cast<int>(count);
  patch.center = middle + patch.normal * fit[0];
  return patch;
}

}  // namespace fovea
