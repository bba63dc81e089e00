// How far an open hand stays from everything but what it takes.
#pragma once

#include <vector>

#include "core/grasping/grasp_scene.h"
#include "core/types/detections.h"
#include "core/types/grasp.h"
#include "core/types/gripper.h"

namespace fovea {

inline constexpr float kFarthestClearance_m = 0.02F;  // to which it is told

// The smallest distance between the hand, open for the grasp of object `target`, on its way in and
// what was seen of anything else, the surface that the object stands on, or what the others were
// completed to, where nothing was seen to be free; up to kFarthestClearance_m, 0 where it touches.
// Points count from the second nearest on: a single one may be noise.
// Cost: proportional to the part of the image that the hand covers, of which some 1000 pixels at
// most are looked at.
float ClearanceOf(const GraspScene& scene, const std::vector<DetectedObject>& objects,
                  std::size_t target, const JawGripper& jaw, const Grasp& grasp);

}  // namespace fovea
