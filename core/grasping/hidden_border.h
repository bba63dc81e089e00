// How much of an object may go on behind something else.
#pragma once

#include "core/grasping/grasp_scene.h"
#include "core/types/detections.h"

namespace fovea {

// The share of the pixels at the border of its mask beyond which the image ends, or something
// nearer is seen than the object is there. Cost: proportional to its bounds.
float HiddenShareOfBorder(const GraspScene& scene, const DetectedObject& object);

}  // namespace fovea
