// What the camera knows of the room that a hand passes on its way to an object.
#pragma once

#include "core/grasping/grasp_scene.h"
#include "core/types/grasp.h"
#include "core/types/gripper.h"

namespace fovea {

// Shares of a cross section of what the palm, or the tube of a cup, passes, each of the section
// where it is most, 0 … 1.
struct UnseenWay {
  float unseen = 0;  // not seen to be free: hidden, without depth or outside of the image
  float hidden = 0;  // by something nearer that is not the object
};

// From the palm's place in the grasp, or 4 cm behind a lip, to where the hand begins, at least
// kLeastWay_m. `label`: of the object. Some 500 pixels are looked at.
UnseenWay LookAtWay(const GraspScene& scene, int label, const Gripper& gripper, const Grasp& grasp);

}  // namespace fovea
