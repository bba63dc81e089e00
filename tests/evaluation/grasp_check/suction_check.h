// Whether a suction cup takes an object, judged by the true solids alone.
#pragma once

#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/outcome.h"
#include "tests/evaluation/grasp_check/physical_scene.h"

namespace fovea::evaluation {

// World frame.
struct SuctionPose {
  Eigen::Vector3d tool_center_point;  // the middle of the lip on the surface
  Eigen::Vector3d approach;           // unit
};

// The cup, of its lip's diameter and 150 mm long, moves in along the approach until it meets the
// target, at most 10 mm before or behind the tool centre point, and touches nothing else. Rays to
// 16 places of the lip, 16 at half its radius and the middle must all meet the target. It seals if
// these lie within 1.5 mm of the plane of the lip, and inside the lip as much more as the largest
// curvature rises there; and the surface in the middle faces the cup to 15°. It holds if the axis
// passes the centre of mass at no more than 4/3 diameters (40 mm for a 30 mm cup: what lies further
// out twists more than a cup of some 60 kPa below the air holds of objects of a kilogram).
Outcome CheckSuction(const PhysicalScene& scene, int target, const SuctionGripper& gripper,
                     const SuctionPose& pose);

}  // namespace fovea::evaluation
