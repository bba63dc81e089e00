#pragma once

#include <string>

#include "client/cli/connection.h"
#include "client/rpc_error.h"

namespace fovea::cli {

// What a person should read about a call that failed: gRPC's own text about a server that is away,
// that does not answer or that wants something else names no remedy. `limit` is the longest wait
// for the answer, with the flag that sets it: "30 s (--timeout)".
std::string Explain(const client::RpcError& error, const ConnectionFlags& flags,
                    const std::string& limit);

// Of calls that are given no limit.
std::string DefaultLimit();

}  // namespace fovea::cli
