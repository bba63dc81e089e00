// The log of the whole process.
#pragma once

#include <string>

namespace fovea::server {

// To stderr. `level`: trace, debug, info, warn, error or off.
void SetUpLogging(const std::string& level);
void SetLogLevel(const std::string& level);

}  // namespace fovea::server
