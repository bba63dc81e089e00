#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <cstddef>
#include <string>

namespace fovea::server {

// One line per frame: at info what was found, at warning what went wrong. Names and texts that
// came from outside are escaped and shortened.
void LogFrame(const std::string& frame_id, const grpc::Status& status, std::size_t num_objects,
              std::chrono::steady_clock::duration took);

}  // namespace fovea::server
