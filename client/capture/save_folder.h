#pragma once

#include <string>

namespace fovea::capture {

// Makes `folder` where it is missing; empty stands for none. Throws std::invalid_argument that
// names
// --save where it cannot be written to, or holds frames: those of two runs in one folder would pass
// for one run with the cameras of the later.
void PrepareSaveFolder(const std::string& folder);

}  // namespace fovea::capture
