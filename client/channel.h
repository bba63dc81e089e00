#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>

#include <chrono>
#include <memory>
#include <string>

#include "client/client_options.h"
#include "client/server_address.h"

namespace fovea::client {

// To one server; `has_others` = of several, so that little time is spent on one that is not there.
std::shared_ptr<grpc::Channel> MakeChannel(const ServerTarget& target, bool has_others,
                                           const ClientOptions& options);

// Waits and lets the channel work meanwhile. gRPC reads from a connection only while somebody waits
// for its channel or for a call on it, and calls on a channel that is away end at once: between
// them, whoever just sleeps keeps a new connection from coming about.
void Pause(grpc::Channel& channel, std::chrono::milliseconds wait);

// What every call carries: its deadline, who calls, and its own names.
void PrepareCall(const ClientOptions& options, std::chrono::milliseconds timeout,
                 grpc::ClientContext* context, const CallOptions& call = {});

}  // namespace fovea::client
