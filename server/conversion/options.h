#pragma once

#include "core/options.h"
#include "fovea/v1/detection.pb.h"
#include "server/conversion/option_policy.h"

namespace fovea::server {

// The profile with the request's changes, where the policy allows these, and with what it fixes.
// Throws std::invalid_argument that starts with the path of the field, such as "options.profile" or
// "options.parameters[name]".
DetectorOptions FromProto(const v1::DetectOptions& options, const OptionPolicy& policy = {});

}  // namespace fovea::server
