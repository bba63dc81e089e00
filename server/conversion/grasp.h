#pragma once

#include <string>

#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// With the name of the gripper, one of those that were asked for.
v1::Grasp ToProto(const Grasp& grasp, const std::string& gripper_name);
v1::NoGrasp ToProto(const NoGrasp& none, const std::string& gripper_name);

}  // namespace fovea::server
