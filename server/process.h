// What is set once for the whole process.
#pragma once

#include <string>

namespace fovea::server {

// To stderr. `level`: trace, debug, info, warn, error or off.
void SetUpLogging(const std::string& level);
void SetLogLevel(const std::string& level);

// Memory and threads for `num_threads` detections side by side. Before any thread starts.
void SetUpProcess(int num_threads);

}  // namespace fovea::server
