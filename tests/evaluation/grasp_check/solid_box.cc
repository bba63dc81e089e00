#include "tests/evaluation/grasp_check/solid_box.h"

namespace fovea::evaluation {
namespace {

// Half the length of the box's shadow on a line.
double HalfShadow(const SolidBox& box, const Eigen::Vector3d& line) {
  return (box.world_from_box.linear().transpose() * line).cwiseAbs().dot(box.half_m);
}

}  // namespace

bool Meet(const SolidBox& a, const SolidBox& b) {
  const Eigen::Matrix3d axes_a = a.world_from_box.linear(), axes_b = b.world_from_box.linear();
  const Eigen::Vector3d apart = b.world_from_box.translation() - a.world_from_box.translation();
  const auto separates = [&](const Eigen::Vector3d& line) {
    // Parallel edges give no line.
    return line.squaredNorm() > 1e-12 &&
           std::abs(apart.dot(line)) >= HalfShadow(a, line) + HalfShadow(b, line);
  };
  for (int i = 0; i < 3; ++i) {
    if (separates(axes_a.col(i)) || separates(axes_b.col(i))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (separates(axes_a.col(i).cross(axes_b.col(j)))) return false;
    }
  }
  return true;
}

bool Contains(const SolidBox& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from_middle = point - box.world_from_box.translation();
  const Eigen::Vector3d in_box = box.world_from_box.linear().transpose() * from_middle;
  return (in_box.cwiseAbs().array() < box.half_m.array()).all();
}

}  // namespace fovea::evaluation
