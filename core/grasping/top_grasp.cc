#include "core/grasping/top_grasp.h"

#include <algorithm>

namespace fovea {

Grasp GraspFromAbove(const OrientedBox& box, const TopGraspOptions& options) {
  const Eigen::Vector3f up = box.rotation.col(2);
  const float height = box.size_m.z();
  const float depth = std::min(static_cast<float>(options.finger_depth_m), height / 2);
  return {.tool_center_point = box.center + up * (height / 2 - depth),
          .approach = -up,
          .closing = box.rotation.col(1),
          .opening_m = box.size_m.y()};
}

}  // namespace fovea
