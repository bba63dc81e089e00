#pragma once

#include <vector>

#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// With the numbers of `given`, from which it was made, where the floats are those: 0.085, and not
// 0.0850000009, which is more than was said. Where nothing was given, the shortest numbers that the
// floats stand for.
v1::Gripper ToProto(const Gripper& gripper, const v1::Gripper& given = {});

// Those to plan grasps for: none where `options` wants none, one of two fingers and 0.085 m where
// it names none. Throws std::invalid_argument that starts with the path of the field.
std::vector<Gripper> FromProto(const v1::GraspOptions& options);

}  // namespace fovea::server
