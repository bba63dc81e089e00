// The frames of a bug report, as fovea-observer saves them.
#pragma once

#include <string>

#include "client/cli/frame_list.h"

namespace fovea::cli {

// "x.zip".
bool IsBundle(const std::string& path);

// All of its frames, with what was asked and answered. Throws std::runtime_error that names the
// file.
FrameList ListBundle(const std::string& path);

}  // namespace fovea::cli
