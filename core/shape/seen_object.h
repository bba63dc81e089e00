// What is known of an object when a solid is looked for.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/shape/level_frame.h"
#include "core/shape/outline.h"
#include "core/shape/solid.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// What was seen of an object, in the level frame that its solid is in.
struct SeenObject {
  LevelPoints points;  // on its surface
  SeenArray noise_m;   // standard deviation of each, along its normal
  Eigen::Vector3f camera = Eigen::Vector3f::Zero();
  LevelPoints directions;  // from the camera: rays through its outline, of any length
  SeenArray outline_noise_m;
  SeenArray is_own_end;  // 1 where the object ends there; 0 where it may go on behind
};

// Some of its points and of the rays through its outline, in a level frame.
SeenObject See(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
               const CameraIntrinsics& intrinsics, const LevelFrame& frame);

}  // namespace fovea
