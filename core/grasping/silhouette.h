// How what is seen of an object fills the outline of the solid that it is taken for.
#pragma once

#include "core/grasping/grasp_scene.h"
#include "core/types/detections.h"

namespace fovea {

// Shares 0 … 1, by rays from the camera through pixels in and around the object's bounds. Of what
// is taken for its box alone, the same of that.
struct Silhouette {
  float seen_through = 0;  // of the rays that should meet the solid: something farther is seen
  float beside = 0;        // of the object's pixels: their rays miss the solid
};

// Pixels of other things that are nearer, or not measured, count for nothing. At most some 6,000
// rays.
Silhouette SilhouetteOf(const GraspScene& scene, const DetectedObject& object);

}  // namespace fovea
