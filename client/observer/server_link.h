#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>
#include <vector>

#include "client/client_options.h"

namespace fovea::observer {

// One server that is watched.
struct ServerLink {
  std::string address;  // as it was given
  std::shared_ptr<grpc::Channel> channel;
};

// Of "HOST:PORT" or several with commas between. Names are looked up once, and those that are not
// found now are asked of gRPC later. Throws std::invalid_argument for what is no address.
std::vector<ServerLink> LinkServers(const std::string& addresses,
                                    const client::ClientOptions& options);

}  // namespace fovea::observer
