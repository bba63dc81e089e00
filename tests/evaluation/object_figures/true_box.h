// The gravity-aligned boxes of true objects, and how much boxes have in common.
#pragma once

#include "core/types/detections.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

// The smallest box around the body with an axis upwards; world frame, axes as OrientedBox has them.
OrientedBox TrueBox(const scenes::Body& body);

// The same with this x axis (made horizontal), for bodies that look the same from all sides.
OrientedBox TrueBoxAlong(const scenes::Body& body, const Eigen::Vector3f& x_axis);

// An answer's box in the world frame.
OrientedBox InWorld(const OrientedBox& box, const Eigen::Isometry3d& world_from_camera);

// Volume shared / volume of both together, to some 1 % (32 x 32 x 32 samples of `truth`); 0 where
// one has no volume.
double BoxIou(const OrientedBox& truth, const OrientedBox& answer);

}  // namespace fovea::evaluation
