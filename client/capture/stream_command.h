#pragma once

#include "client/capture/flags.h"

namespace fovea::capture {

// A camera or a recording → server → a line per answer and a summary. Returns the exit code; throws
// std::exception with one line of text.
int RunStream(const StreamFlags& flags);

}  // namespace fovea::capture
