// What the camera says of a place in the scene.
#pragma once

#include <Eigen/Core>

#include "core/grasping/grasp_scene.h"

namespace fovea {

enum class Sight {
  kFree,            // something behind it is seen
  kOnTarget,        // the object itself is seen there
  kBehindTarget,    // the object hides it
  kBehindOther,     // something else hides it
  kUnmeasured,      // no depth
  kOutsideOfImage,  // or behind the camera
};

// `place`: camera frame. Within the tolerance, which grows with the square of the distance as the
// noise of depth cameras does, of a measured point it is at it; of another's that counts as free.
Sight SightOf(const GraspScene& scene, int label, const Eigen::Vector3f& place);
// The same by what was measured, without limit of distance and without points that are assumed.
Sight MeasuredSightOf(const GraspScene& scene, int label, const Eigen::Vector3f& place);

// Whether a pixel is so near to the mask of an object that it may be of it.
bool IsAtMask(const GraspScene& scene, int row, int column, int label);

}  // namespace fovea
