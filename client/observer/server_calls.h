// What the observer asks of servers for one who looks, with that one's token.
#pragma once

#include <grpcpp/support/status.h>

#include <stop_token>
#include <string>

#include "client/observer/server_link.h"
#include "fovea/v1/observation_service.pb.h"

namespace fovea::observer {

// Each waits for its answer, some seconds at most, or until `stop`.
grpc::Status Try(const ServerLink& server, const std::string& token, const v1::TryRequest& request,
                 v1::TryResponse* response, const std::stop_token& stop);
grpc::Status ListOptions(const ServerLink& server, const std::string& token,
                         v1::ListOptionsResponse* response, const std::stop_token& stop);
grpc::Status SelectObject(const ServerLink& server, const std::string& token,
                          const v1::SelectObjectRequest& request,
                          v1::SelectObjectResponse* response, const std::stop_token& stop);

}  // namespace fovea::observer
