#include "core/grasping/plan_grasps.h"

#include "core/grasping/top_grasp.h"
#include "core/types/interruption.h"

namespace fovea {

void PlanGrasps(const GraspScene& /*scene*/, const std::vector<Gripper>& grippers,
                std::vector<DetectedObject>& objects) {
  for (DetectedObject& object : objects) {
    InterruptionPoint();
    for (std::size_t i = 0; i < grippers.size(); ++i) {
      if (!std::holds_alternative<JawGripper>(grippers[i].hand)) continue;
      object.grasps.push_back(GraspFromAbove(object.box));
      object.grasps.back().gripper = i;
    }
  }
}

}  // namespace fovea
