#include "core/grasping/hollow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fovea {
namespace {

constexpr float kBelowRim_m = 0.008F;
constexpr float kLeastWall_m = 0.004F;

// Of rings about the axis, one cell wide and none beyond the radius, or the rim would be lowered as
// well and the palm would meet it: how low it is empty.
class Rings {
 public:
  Rings(float radius_m, float width_m)
      : width_m_(width_m),
        lowest_(static_cast<std::size_t>(std::max(1.0F, radius_m / width_m)), -HandGrid::kNothing) {
  }

  void IsEmptyAt(float radius_m, float height_m) {
    const auto ring = static_cast<std::size_t>(radius_m / width_m_);
    if (ring < lowest_.size()) lowest_[ring] = std::min(lowest_[ring], height_m);
  }

  float LowestAt(float radius_m) const {
    const auto ring = static_cast<std::size_t>(radius_m / width_m_);
    return ring < lowest_.size() ? lowest_[ring] : -HandGrid::kNothing;
  }

  // What is further in is at least as deep as the deepest around it.
  void FillInwards() {
    for (std::size_t i = lowest_.size() - 1; i-- > 0;) {
      lowest_[i] = std::min(lowest_[i], lowest_[i + 1]);
    }
  }

 private:
  float width_m_;
  std::vector<float> lowest_;
};

// Half a step above the last of its radii.
float RimRadiusOf(const Shape& shape) {
  const std::vector<float>& radii = shape.radii_m;
  if (radii.size() < 2) return shape.radius_m;
  const float last = radii.back(), before = radii[radii.size() - 2];
  return std::min(shape.radius_m, last + (last - before) / 2);
}

// From a point inside towards the camera until it leaves through the top.
void FollowSight(const Eigen::Vector3f& point, const Eigen::Vector3f& camera,
                 const Eigen::Vector2f& axis, float top_m, float step_m, Rings& rings) {
  constexpr int kMostSteps = 64;
  const Eigen::Vector3f way = (camera - point).normalized() * step_m;
  Eigen::Vector3f at = point;
  for (int i = 0; i < kMostSteps && at.z() < top_m; ++i) {
    rings.IsEmptyAt((at.head<2>() - axis).norm(), at.z());
    at += way;
  }
}

}  // namespace

void HollowOut(const DetectedObject& object, HandGrid& grid) {
  constexpr float kAligned = 0.9F;  // cosine
  constexpr std::size_t kMostPoints = 400;
  const Eigen::Vector3f axis = grid.frame.rotation.transpose() * object.shape.axis;
  if (axis.z() < kAligned) return;
  const Eigen::Vector3f center = grid.frame.FromCamera(object.shape.center);
  const float top = center.z() + object.shape.length_m / 2;
  const Eigen::Vector3f camera = grid.frame.FromCamera(Eigen::Vector3f::Zero());
  const float radius = RimRadiusOf(object.shape);
  Rings rings(radius - kLeastWall_m, grid.cell_m);
  const std::size_t stride = object.cloud.size() / kMostPoints + 1;
  for (std::size_t i = 0; i < object.cloud.size(); i += stride) {
    const ColoredPoint& seen = object.cloud[i];
    const Eigen::Vector3f p = grid.frame.FromCamera({seen.x, seen.y, seen.z});
    const float from_axis = (p.head<2>() - center.head<2>()).norm();
    if (p.z() > top - kBelowRim_m || from_axis > radius - kLeastWall_m) continue;
    // What lies on the near side is the outside, unless it faces away.
    const Eigen::Vector2f to_camera = (camera - p).head<2>();
    const bool is_inside = from_axis < radius / 2 || (p - center).head<2>().dot(to_camera) < 0;
    if (is_inside) {
      FollowSight(p, camera, center.head<2>(), top, grid.cell_m / 2, rings);
    }
  }
  rings.FillInwards();
  for (int row = 0; row < grid.size; ++row) {
    for (int column = 0; column < grid.size; ++column) {
      float& target = grid.At(row, column).target;
      const Eigen::Vector2f at(grid.MiddleOf(column), grid.MiddleOf(row));
      const float lowest = rings.LowestAt((at - center.head<2>()).norm());
      if (target > HandGrid::kNothing) target = std::min(target, lowest);
    }
  }
}

}  // namespace fovea
