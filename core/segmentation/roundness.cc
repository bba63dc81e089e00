#include "core/segmentation/roundness.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

constexpr float kMinDirection = 0.2F;  // horizontal share of a normal that tells a direction
constexpr double kMinSpread = 1e-6;    // variance of directions that tells a radius

// Sums over pairs of places and directions in the horizontal plane.
struct Moments {
  double count = 0;
  Eigen::Vector3d place_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_sum = Eigen::Vector3d::Zero();
  double place_squares = 0, direction_squares = 0, products = 0;

  void Add(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) {
    count += 1;
    place_sum += place;
    direction_sum += direction;
    place_squares += place.squaredNorm();
    direction_squares += direction.squaredNorm();
    products += place.dot(direction);
  }
  double PlaceVariance() const { return place_squares / count - (place_sum / count).squaredNorm(); }
  double DirectionVariance() const {
    return direction_squares / count - (direction_sum / count).squaredNorm();
  }
  double Covariance() const {
    return products / count - (place_sum / count).dot(direction_sum / count);
  }
};

}  // namespace

Roundness FitRoundness(const VoxelGrid& grid, std::span<const int> voxels,
                       const Eigen::Vector3f& up) {
  Moments all, directed;  // with the normals' horizontal parts; with unit vectors along them
  for (const int v : voxels) {
    const Eigen::Vector3d place = Horizontal(grid.voxels[v].mean, up).cast<double>();
    const Eigen::Vector3f normal = Horizontal(grid.voxels[v].normal, up);
    all.Add(place, normal.cast<double>());
    if (normal.norm() >= kMinDirection) directed.Add(place, normal.normalized().cast<double>());
  }
  Roundness roundness;
  if (all.count == 0 || all.PlaceVariance() <= 0) return roundness;
  roundness.curvature_per_m = all.Covariance() / all.PlaceVariance();
  if (directed.count == 0 || directed.DirectionVariance() < kMinSpread) return roundness;
  roundness.radius_m =
      std::sqrt(std::max(0.0, directed.PlaceVariance()) / directed.DirectionVariance());
  const double towards_axis = roundness.curvature_per_m < 0 ? 1 : -1;
  roundness.axis =
      ((directed.place_sum + towards_axis * roundness.radius_m * directed.direction_sum) /
       directed.count)
          .cast<float>();
  return roundness;
}

double MeanFacing(const VoxelGrid& grid, std::span<const int> voxels, const Eigen::Vector3f& axis,
                  const Eigen::Vector3f& up) {
  double sum = 0, count = 0;
  for (const int v : voxels) {
    const Eigen::Vector3f normal = Horizontal(grid.voxels[v].normal, up);
    const Eigen::Vector3f way = Horizontal(grid.voxels[v].mean, up) - axis;
    if (normal.norm() < kMinDirection || way.isZero()) continue;
    sum += normal.normalized().dot(way.normalized());
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace fovea
