#pragma once

#include <string>

#include "client/cli/detect_flags.h"
#include "client/rpc_error.h"

namespace fovea::cli {

// What a person should read about a call of this command that failed.
std::string ExplainDetect(const client::RpcError& error, const DetectFlags& flags);

// Returns the exit code; throws std::exception with one line of text.
int RunDetect(const DetectFlags& flags);

}  // namespace fovea::cli
