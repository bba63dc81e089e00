#include "tests/evaluation/grasp_check/check_grasp.h"

#include "tests/evaluation/grasp_check/jaw_check.h"
#include "tests/evaluation/grasp_check/suction_check.h"

namespace fovea::evaluation {

Outcome CheckGrasp(const PhysicalScene& scene, int target, const Gripper& gripper,
                   const Grasp& grasp) {
  const Eigen::Isometry3d& world_from_camera = scene.Scene().camera.world_from_camera;
  const Eigen::Vector3d tip = world_from_camera * grasp.tool_center_point.cast<double>();
  const Eigen::Vector3d approach = world_from_camera.linear() * grasp.approach.cast<double>();
  if (const auto* suction = std::get_if<SuctionGripper>(&gripper.hand)) {
    return CheckSuction(scene, target, *suction, {tip, approach.normalized()});
  }
  const Eigen::Vector3d closing = world_from_camera.linear() * grasp.closing.cast<double>();
  return CheckJaw(scene, target, std::get<JawGripper>(gripper.hand),
                  {tip, approach.normalized(), closing.normalized(), double{grasp.opening_m},
                   double{grasp.pre_grasp_opening_m}});
}

}  // namespace fovea::evaluation
