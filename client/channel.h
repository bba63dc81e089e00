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

// What every call carries: its deadline, and who calls.
void PrepareCall(const ClientOptions& options, std::chrono::milliseconds timeout,
                 grpc::ClientContext* context);

}  // namespace fovea::client
