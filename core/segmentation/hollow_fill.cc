#include "core/segmentation/hollow_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "core/depth/depth_gap.h"
#include "core/scene/level_axes.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr double kFloor_m = 0.03;  // below the lowest visible part of the wall
// A rim is looked for in these directions, at these multiples of the radius, as the fitted circle
// may be too small; where one sees through it in more than that share, it is open.
constexpr int kRimDirections = 24;
constexpr std::array<double, 3> kRimRadii = {1, 1.1, 1.2};
constexpr double kMaxOpen = 0.5;
// What is filled ends at objects; where more of its border than that is one with background, it is
// a part of the surface below.
constexpr double kMaxLeak = 0.6;

bool Encloses(const RoundWall& wall, const Eigen::Vector2d& place, double height_m) {
  return (place - wall.center).norm() < wall.radius_m && height_m < wall.rim_m &&
         height_m > wall.foot_m - kFloor_m;
}

// Whether one sees something farther away where the point is.
bool IsSeenThrough(const Eigen::Vector3f& point, const cv::Mat& points,
                   const CameraIntrinsics& intrinsics) {
  if (point.z() <= 0) return false;
  const cv::Point pixel = Project(point, intrinsics);  // rounds
  if (!cv::Rect({}, points.size()).contains(pixel)) return false;
  return points.at<cv::Vec3f>(pixel)[2] > point.z() + DepthGap_m(point.z());  // false for NaN
}

// Whether a rim goes all around, for what one can see: that of a banana's inner side does not.
bool HasRim(const RoundWall& wall, const cv::Mat& points, const CameraIntrinsics& intrinsics,
            const Eigen::Vector3f& up) {
  const LevelAxes axes = LevelAxesFor(up);
  int num_open = 0;
  for (int i = 0; i < kRimDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRimDirections;
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const bool is_open = std::all_of(kRimRadii.begin(), kRimRadii.end(), [&](double multiple) {
      const Eigen::Vector2d place = wall.center + multiple * wall.radius_m * way;
      const Eigen::Vector3f rim =
          axes.transpose() * place.cast<float>() + static_cast<float>(wall.rim_m) * up;
      return IsSeenThrough(rim, points, intrinsics);
    });
    num_open += is_open ? 1 : 0;
  }
  return num_open <= kMaxOpen * kRimDirections;
}

// Spreads the labels of walls to the background that they enclose, neighbour by neighbour: what
// lies outside below a rim is parted from the inside by the wall.
void Fill(const VoxelGrid& grid, const std::vector<char>& on_wall, const RoundWalls& walls,
          const Eigen::Vector3f& up, std::vector<int>& labels) {
  const LevelAxes axes = LevelAxesFor(up);
  const auto encloses = [&](const std::optional<RoundWall>& wall, int v) {
    const Eigen::Vector3f& point = grid.voxels[v].mean;
    return wall && Encloses(*wall, (axes * point).cast<double>(), up.dot(point));
  };
  const auto takes_part = [&](int v) {
    if (labels[v] != 0) return walls[labels[v]].has_value();
    return !on_wall[v] && std::any_of(walls.begin(), walls.end(),
                                      [&](const auto& wall) { return encloses(wall, v); });
  };
  std::vector<char> parts;
  parts.reserve(labels.size());
  for (int v = 0; v < static_cast<int>(labels.size()); ++v) parts.push_back(takes_part(v) ? 1 : 0);
  std::vector<VoxelEdge> edges;
  std::copy_if(grid.edges.begin(), grid.edges.end(), std::back_inserter(edges),
               [&](const VoxelEdge& edge) { return parts[edge.a] != 0 && parts[edge.b] != 0; });
  const auto spread = [&](int from, int to) {
    if (labels[to] != 0 || !encloses(walls[labels[from]], to)) return false;
    labels[to] = labels[from];
    return true;
  };
  for (bool changed = true; changed;) {
    InterruptionPoint();
    changed = false;
    for (const VoxelEdge& edge : edges) {
      if (spread(edge.a, edge.b) || spread(edge.b, edge.a)) changed = true;
    }
  }
}

struct Border {
  int with_objects = 0;
  int with_background = 0;
};

// Of what Fill gave to each piece, one entry a piece.
std::vector<Border> BordersOfFilled(const VoxelGrid& grid, const std::vector<int>& pieces,
                                    const std::vector<int>& filled, std::size_t num_pieces) {
  std::vector<Border> borders(num_pieces);
  const auto count = [&](int from, int to) {
    if (pieces[from] != 0 || filled[from] == 0) return;
    Border& border = borders[filled[from]];
    if (filled[to] == 0) ++border.with_background;
    if (pieces[to] != 0) ++border.with_objects;
  };
  for (const VoxelEdge& edge : grid.edges) {
    count(edge.a, edge.b);
    count(edge.b, edge.a);
  }
  return borders;
}

// Takes back what runs out into the background: noise on a flat side may look like the inside of a
// wall, with a disc of table before it.
void EmptyLeaking(const VoxelGrid& grid, const std::vector<int>& pieces, std::size_t num_pieces,
                  std::vector<int>& filled) {
  const std::vector<Border> borders = BordersOfFilled(grid, pieces, filled, num_pieces);
  for (std::size_t v = 0; v < filled.size(); ++v) {
    const Border& border = borders[filled[v]];
    const int length = border.with_objects + border.with_background;
    if (pieces[v] == 0 && border.with_background > kMaxLeak * length) filled[v] = 0;
  }
}

}  // namespace

std::vector<int> FillHollows(const VoxelGrid& grid, const std::vector<int>& objects,
                             const std::vector<int>& pieces, RoundWalls walls,
                             const cv::Mat& points, const CameraIntrinsics& intrinsics,
                             const std::vector<char>& on_wall, const Eigen::Vector3f& up) {
  for (std::optional<RoundWall>& wall : walls) {
    InterruptionPoint();
    if (wall && !(wall->is_inside && HasRim(*wall, points, intrinsics, up))) wall.reset();
  }
  if (std::none_of(walls.begin(), walls.end(), [](const auto& wall) { return wall.has_value(); })) {
    return objects;
  }
  std::vector<int> object_of(walls.size(), 0);
  for (std::size_t v = 0; v < pieces.size(); ++v) object_of[pieces[v]] = objects[v];
  std::vector<int> filled = pieces;
  Fill(grid, on_wall, walls, up, filled);
  EmptyLeaking(grid, pieces, walls.size(), filled);
  std::transform(filled.begin(), filled.end(), filled.begin(),
                 [&](int piece) { return object_of[piece]; });
  return Renumbered(std::move(filled));
}

}  // namespace fovea
