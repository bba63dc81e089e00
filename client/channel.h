#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>

#include <chrono>
#include <memory>
#include <string>

#include "client/client_options.h"

namespace fovea::client {

// `address` as Client takes it.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ClientOptions& options);

// Waits and lets the channel work meanwhile. gRPC reads from a connection only while somebody waits
// for its channel or for a call on it, and calls on a channel that is away end at once: between
// them, whoever just sleeps keeps a new connection from coming about.
void Pause(grpc::Channel& channel, std::chrono::milliseconds wait);

// What every call carries: its deadline, and who calls.
void PrepareCall(const ClientOptions& options, std::chrono::milliseconds timeout,
                 grpc::ClientContext* context);

}  // namespace fovea::client
