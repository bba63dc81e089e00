#include "core/grasping/grid_points.h"

#include <algorithm>
#include <cmath>

#include "core/types/interruption.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr float kRoomAbove_m = 0.2F;  // the hand and the arm behind it, above the object

// The part of the image in which the grid's columns are seen.
cv::Rect SeenPart(const GraspScene& scene, float half_height_m, const HandGrid& grid) {
  const cv::Rect image({}, scene.points.size());
  cv::Rect2d part;
  for (const float z : {-half_height_m, half_height_m + kRoomAbove_m}) {
    for (const float y : {-grid.Half(), grid.Half()}) {
      for (const float x : {-grid.Half(), grid.Half()}) {
        const Eigen::Vector3f corner = grid.frame.ToCamera({x, y, z});
        if (corner.z() < 0.05F) return image;
        const cv::Rect2d pixel(Project(corner, scene.intrinsics), cv::Size2d(1, 1));
        part = part.empty() ? pixel : part | pixel;
      }
    }
  }
  part &= cv::Rect2d(image);
  return image & cv::Rect(cvFloor(part.x), cvFloor(part.y), cvCeil(part.width) + 1,
                          cvCeil(part.height) + 1);
}

// The two highest.
struct TwoHighest {
  float first = HandGrid::kNothing, second = HandGrid::kNothing;

  void Add(float height) {
    second = std::max(second, std::min(first, height));
    first = std::max(first, height);
  }
};

bool IsAtMask(const GraspScene& scene, int row, int column, int label) {
  constexpr int kAway_px = 2;
  const auto is_label = [&](int r, int c) {
    return r >= 0 && c >= 0 && r < scene.labels.rows && c < scene.labels.cols &&
           scene.labels.ptr<std::uint16_t>(r)[c] == label;
  };
  return is_label(row, column - kAway_px) || is_label(row, column + kAway_px) ||
         is_label(row - kAway_px, column) || is_label(row + kAway_px, column);
}

// How far outside of the solid its points count beside it: parts that it does not have.
bool IsBeside(const CompletedSolid& solid, const Eigen::Vector3f& point, float noise_m) {
  const Eigen::Vector3f from = point - solid.Center();
  const Eigen::Vector3f direction = from.normalized();
  const auto span = solid.Along(solid.Center(), direction);
  return !span || from.norm() - span->high > 0.01F + 2 * noise_m;
}

}  // namespace

void AddPoints(const GraspScene& scene, const DetectedObject& object, const CompletedSolid& solid,
               const Eigen::Vector3f& half_extents, HandGrid& grid) {
  constexpr int kMostPixels = 60000;
  constexpr float kOnFloor_m = 0.008F, kNoisePer_m = 0.003F;  // metres, of the distance squared
  const cv::Rect part = SeenPart(scene, half_extents.z(), grid);
  const int step = std::max(1, cvCeil(std::sqrt(part.area() / static_cast<double>(kMostPixels))));
  const Eigen::Matrix3f axes = grid.frame.rotation.transpose();
  const Eigen::Vector3f origin = axes * grid.frame.origin;
  std::vector<TwoHighest> of_target(grid.columns.size()), of_others(grid.columns.size());
  for (int row = part.y; row < part.br().y; row += step) {
    InterruptionPoint();
    const auto* points = scene.points.ptr<Eigen::Vector3f>(row);
    const auto* labels = scene.labels.ptr<std::uint16_t>(row);
    for (int column = part.x; column < part.br().x; column += step) {
      const Eigen::Vector3f& seen = points[column];
      if (std::isnan(seen.z())) continue;
      const int label = labels[column];
      const bool is_target = label == object.label;
      if (is_target && solid.IsKnown() && object.shape.kind == Shape::Kind::kBox) continue;
      const Eigen::Vector3f at = axes * seen - origin;
      const int x = grid.CellAt(at.x()), y = grid.CellAt(at.y());
      if (x < 0 || y < 0 || x >= grid.size || y >= grid.size) continue;
      const auto cell = static_cast<std::size_t>(y * grid.size + x);
      const float noise = kNoisePer_m * seen.z() * seen.z();
      if (is_target) {
        if (!solid.IsKnown() || IsBeside(solid, at, noise)) of_target[cell].Add(at.z());
        continue;
      }
      if (label == 0) {
        const float above = grid.floor_normal.dot(at) + grid.floor_offset_m;
        if (above < kOnFloor_m + noise || IsAtMask(scene, row, column, object.label)) continue;
      }
      of_others[cell].Add(at.z());
    }
  }
  for (std::size_t i = 0; i < grid.columns.size(); ++i) {
    grid.columns[i] = {of_target[i].second, of_others[i].second};
  }
}

}  // namespace fovea
