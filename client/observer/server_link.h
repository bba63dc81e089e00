#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "client/client_options.h"
#include "client/server_address.h"

namespace fovea::observer {

// Says on standard error when a server goes away and when it is back, once for all who watch it.
// Thread-safe.
class OutageNote {
 public:
  void OnAway(const std::string& address, const std::string& why);
  void OnBack(const std::string& address);

 private:
  std::mutex mutex_;
  bool is_away_ = false;
};

// One server that is watched.
struct ServerLink {
  std::string address;  // as it was given
  std::shared_ptr<grpc::Channel> channel;
  std::shared_ptr<OutageNote> outage = std::make_shared<OutageNote>();
};

// Names are left to gRPC, which tries all of their addresses, and looks them up again where none
// answers: a server may come back with another one.
client::ServerTarget TargetOf(const client::ServerAddress& address);

// Of "HOST:PORT" or several with commas between. Throws std::invalid_argument for what is no
// address.
std::vector<ServerLink> LinkServers(const std::string& addresses,
                                    const client::ClientOptions& options);

}  // namespace fovea::observer
