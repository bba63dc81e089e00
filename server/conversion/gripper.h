#pragma once

#include <vector>

#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

v1::Gripper ToProto(const Gripper& gripper);

// Those to plan grasps for: none where `options` wants none, one of two fingers and 0.085 m where
// it names none. Throws std::invalid_argument that starts with the path of the field.
std::vector<Gripper> FromProto(const v1::GraspOptions& options);

}  // namespace fovea::server
