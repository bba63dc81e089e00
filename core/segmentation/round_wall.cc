#include "core/segmentation/round_wall.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/level_axes.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr std::size_t kMinVoxels = 24;
constexpr double kMinRadius_m = 0.02;
constexpr double kMinArc_rad = 60 * std::numbers::pi / 180;
constexpr double kMinRadial = 0.88;    // mean cosine between normals and the way to the axis
constexpr double kMinSteepness = 0.5;  // mean sine between normals and the vertical
constexpr double kMaxResidual = 0.12;  // of the radius, root mean square

using Places = std::vector<Eigen::Vector2d>;

// Solves x² + y² = 2 cx x + 2 cy y + (r² − cx² − cy²) in the least squares sense.
RoundWall FitCircle(const Places& places) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& place : places) mean += place / static_cast<double>(places.size());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2d p = place - mean;
    const Eigen::Vector3d row(2 * p.x(), 2 * p.y(), 1);
    a += row * row.transpose();
    b += row * p.squaredNorm();
  }
  const Eigen::Vector3d x = a.ldlt().solve(b);
  const double squared = x[2] + x.head<2>().squaredNorm();
  return {.center = mean + x.head<2>(), .radius_m = squared > 0 ? std::sqrt(squared) : 0};
}

// The angle that the places cover around a centre: the full turn less their largest gap.
double ArcAround(const Eigen::Vector2d& center, const Places& places) {
  std::vector<double> angles;
  for (const Eigen::Vector2d& place : places) {
    angles.push_back(std::atan2(place.y() - center.y(), place.x() - center.x()));
  }
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return 2 * std::numbers::pi - gap;
}

std::vector<int> UpperHalf(const VoxelGrid& grid, std::vector<int> voxels,
                           const Eigen::Vector3f& up) {
  const auto is_higher = [&](int a, int b) {
    const float height_a = up.dot(grid.voxels[a].mean), height_b = up.dot(grid.voxels[b].mean);
    return height_a > height_b || (height_a == height_b && a < b);
  };
  std::sort(voxels.begin(), voxels.end(), is_higher);
  voxels.resize(voxels.size() / 2);
  return voxels;
}

enum class Side { kNone, kInside, kOutside };

// Which side of the circle the voxels show, if they follow it.
Side SideOfWall(const VoxelGrid& grid, const std::vector<int>& voxels, const Places& places,
                const LevelAxes& axes, const RoundWall& wall) {
  double squares = 0, inwards = 0, steepness = 0;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Eigen::Vector2d way = wall.center - places[i];
    const Eigen::Vector2d normal = (axes * grid.voxels[voxels[i]].normal).cast<double>();
    squares += std::pow(way.norm() - wall.radius_m, 2);
    inwards += normal.dot(way.normalized());
    steepness += normal.norm();
  }
  const auto count = static_cast<double>(voxels.size());
  if (std::sqrt(squares / count) > kMaxResidual * wall.radius_m ||
      std::abs(inwards) < kMinRadial * steepness || steepness < kMinSteepness * count ||
      ArcAround(wall.center, places) < kMinArc_rad) {
    return Side::kNone;
  }
  return inwards > 0 ? Side::kInside : Side::kOutside;
}

std::optional<RoundWall> FindWall(const VoxelGrid& grid, const std::vector<int>& voxels,
                                  const Eigen::Vector3f& up, const LevelAxes& axes,
                                  double max_radius_m) {
  if (voxels.size() < kMinVoxels) return std::nullopt;
  const std::vector<int> upper = UpperHalf(grid, voxels, up);
  Places places;
  for (const int v : upper) places.emplace_back((axes * grid.voxels[v].mean).cast<double>());
  RoundWall wall = FitCircle(places);
  if (wall.radius_m < kMinRadius_m || wall.radius_m > max_radius_m) return std::nullopt;
  const Side side = SideOfWall(grid, upper, places, axes, wall);
  if (side == Side::kNone) return std::nullopt;
  wall.is_inside = side == Side::kInside;
  const auto height = [&](int v) { return up.dot(grid.voxels[v].mean); };
  wall.rim_m = wall.foot_m = height(voxels.front());
  for (const int v : voxels) {
    wall.rim_m = std::max<double>(wall.rim_m, height(v));
    wall.foot_m = std::min<double>(wall.foot_m, height(v));
  }
  return wall;
}

}  // namespace

RoundWalls FindRoundWalls(const VoxelGrid& grid, const std::vector<int>& labels,
                          const Eigen::Vector3f& up, double max_radius_m) {
  std::vector<std::vector<int>> voxels(CountLabels(labels) + 1);
  if (max_radius_m <= 0) return RoundWalls(voxels.size());
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) {
    if (labels[v] != 0) voxels[labels[v]].push_back(v);
  }
  const LevelAxes axes = LevelAxesFor(up);
  RoundWalls walls;
  walls.reserve(voxels.size());
  for (const std::vector<int>& of_label : voxels) {
    InterruptionPoint();
    walls.push_back(FindWall(grid, of_label, up, axes, max_radius_m));
  }
  return walls;
}

}  // namespace fovea
