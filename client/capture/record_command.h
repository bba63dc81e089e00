#pragma once

#include "client/capture/flags.h"

namespace fovea::capture {

// A camera → a recording of OpenNI2, without loss. However it ends, what was recorded until then
// plays back. Returns the exit code; throws std::exception with one line of text.
int RunRecord(const RecordFlags& flags);

}  // namespace fovea::capture
