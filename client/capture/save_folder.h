#pragma once

#include <string>

namespace fovea::capture {

// Frames of two runs in one folder would pass for one run with the cameras of the later. Throws
// std::invalid_argument that names --save where `folder` holds frames; it need not be there, and
// empty stands for none.
void RequireNoFramesIn(const std::string& folder);

}  // namespace fovea::capture
