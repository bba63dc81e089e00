// A first grasp for every object.
#pragma once

#include "core/types/detections.h"

namespace fovea {

struct TopGraspOptions {
  double finger_depth_m = 0.02;  // how far the finger tips reach below the top of the object
};

// The grasp from straight above across the narrower side of the box's footprint. The tool centre
// point lies on the vertical axis of the box, finger_depth_m below its top but not below its
// middle. Collisions with neighbours are not considered.
Grasp GraspFromAbove(const OrientedBox& box, const TopGraspOptions& options = {});

}  // namespace fovea
