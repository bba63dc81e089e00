#pragma once

#include "fovea/v1/detection_service.pb.h"
#include "server/conversion/option_policy.h"

namespace fovea::server {

// Every option of the method, as requests may set it under this policy.
v1::ListOptionsResponse OptionList(const OptionPolicy& policy);

}  // namespace fovea::server
