#pragma once

#include <string>

#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// With the name of the gripper, one of those that were asked for.
v1::Grasp ToProto(const Grasp& grasp, const std::string& gripper_name);

// Its floats may lie beside the numbers of its gripper by what these were rounded by; then they are
// those.
void KeepWithin(const v1::Gripper& gripper, v1::Grasp* grasp);

v1::NoGrasp ToProto(const NoGrasp& none, const std::string& gripper_name);

}  // namespace fovea::server
