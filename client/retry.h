#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>

#include <chrono>
#include <functional>

#include "client/client_options.h"

namespace fovea::client {

// Whether a call that ended so may be made again. Detection changes nothing on the server, so that
// only matters for what it would bring.
bool IsWorthRetrying(const grpc::Status& status, const grpc::ClientContext& context);

// How long to wait before attempt `attempt` + 1 (the first is 1).
std::chrono::milliseconds BackoffAfter(int attempt, const RetryOptions& options,
                                       const grpc::ClientContext& context);

// Makes the call on this channel, again if need be and while the deadline allows. Throws the
// RpcError of the last attempt where none succeeds.
void CallWithRetries(grpc::Channel& channel, const ClientOptions& options,
                     std::chrono::milliseconds timeout,
                     const std::function<grpc::Status(grpc::ClientContext*)>& call);

}  // namespace fovea::client
