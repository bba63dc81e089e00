#pragma once

#include "core/options.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// The profile with the request's changes. Throws std::invalid_argument that starts with
// "options.profile" or "options.parameters[name]".
DetectorOptions FromProto(const v1::DetectOptions& options);

}  // namespace fovea::server
