#include "tests/evaluation/grasp_check/hand_boxes.h"

#include <algorithm>
#include <vector>

namespace fovea::evaluation {

Eigen::Matrix3d HandAxes(const Eigen::Vector3d& approach, const Eigen::Vector3d& closing) {
  Eigen::Matrix3d axes;
  axes.col(2) = approach.normalized();
  axes.col(1) = approach.cross(closing).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return axes;
}

SolidBox BoxOfHand(const Eigen::Matrix3d& axes, const Eigen::Vector3d& tool_center_point,
                   const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  SolidBox box;
  box.world_from_box.linear() = axes;
  box.world_from_box.translation() = tool_center_point + axes * (low + high) / 2;
  box.half_m = (high - low) / 2;
  return box;
}

std::array<SolidBox, 3> SweptHand(const JawGripper& gripper, const JawPose& pose, double opening_m,
                                  double sweep_m, double inset_m) {
  const Eigen::Matrix3d axes = HandAxes(pose.approach, pose.closing);
  const Eigen::Vector3d inset = Eigen::Vector3d::Constant(inset_m);
  const auto box = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    return BoxOfHand(axes, pose.tool_center_point, low + inset, high - inset);
  };
  const double inner = opening_m / 2, outer = inner + gripper.finger_thickness_m;
  const double side = gripper.finger_width_m / 2, length = gripper.finger_length_m;
  const Eigen::Vector3d palm = PalmOf(gripper).cast<double>();
  return {box({-outer, -side, -length - sweep_m}, {-inner, side, 0}),
          box({inner, -side, -length - sweep_m}, {outer, side, 0}),
          box({-palm.x() / 2, -palm.y() / 2, -length - palm.z() - sweep_m},
              {palm.x() / 2, palm.y() / 2, -length})};
}

Outcome OnTheWayIn(const PhysicalScene& scene, int target, std::span<const SolidBox> hand) {
  const auto touches = [&](int body) {
    return std::any_of(hand.begin(), hand.end(),
                       [&](const SolidBox& box) { return scene.Touches(body, box); });
  };
  if (touches(target)) return Outcome::kHitsTarget;
  Outcome outcome = Outcome::kSuccess;
  const std::vector<scenes::Body>& bodies = scene.Scene().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (static_cast<int>(i) == target || !touches(static_cast<int>(i))) continue;
    if (bodies[i].is_object) return Outcome::kHitsNeighbor;
    outcome = Outcome::kHitsFurniture;
  }
  return outcome;
}

}  // namespace fovea::evaluation
