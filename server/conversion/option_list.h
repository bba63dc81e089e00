#pragma once

#include "fovea/v1/detection_service.pb.h"

namespace fovea::server {

// Every option of the method, as a caller may set it.
v1::ListOptionsResponse OptionList();

}  // namespace fovea::server
