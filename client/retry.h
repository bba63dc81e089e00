#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <functional>
#include <optional>

#include "client/client_options.h"
#include "client/rpc_error.h"
#include "client/servers.h"

namespace fovea::client {

// Whether a call that ended so may be made again. Detection changes nothing on the server, so that
// only matters for what it would bring.
bool IsWorthRetrying(const grpc::Status& status, const grpc::ClientContext& context);

// How long to wait before attempt `attempt` + 1 (the first is 1): as long as the server says, since
// it keeps a place in line that long, else by the options.
std::chrono::milliseconds BackoffAfter(int attempt, const RetryOptions& options,
                                       std::optional<std::chrono::milliseconds> retry_after);

// What the server says in the trailing metadata, of a call that has ended.
std::optional<std::chrono::milliseconds> RetryAfter(const grpc::ClientContext& context);

// Of a call that has ended so; max_answer_mib: of this client.
RpcError ErrorOf(const grpc::Status& status, const grpc::ClientContext& context,
                 const CallOptions& call, int max_answer_mib);

// Makes the call: around the servers until one answers, and again if need be and while the deadline
// allows. A way around is one attempt; those after which a server says when to come back are not
// counted. Throws the RpcError of the last one where none succeeds; of
// refusals the one of the server that it would have waited for.
void CallWithRetries(
    Servers& servers, const ClientOptions& options, std::chrono::milliseconds timeout,
    const std::function<grpc::Status(v1::DetectionService::Stub&, grpc::ClientContext*)>& call,
    const CallOptions& call_options = {});

}  // namespace fovea::client
