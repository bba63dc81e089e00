#pragma once

#include <grpcpp/server_context.h>

#include <memory>
#include <mutex>
#include <string>

#include "server/access/token_table.h"
#include "server/scheduling/robot_id.h"

namespace fovea::server {

// Lets calls in and knows who they are. Thread-safe.
class GateKeeper {
 public:
  // `tokens` is a file for TokenTable, or empty: then all that connect may call.
  explicit GateKeeper(std::string tokens);

  // Takes over what the file holds now. Throws like TokenTable::FromFile, and changes nothing then.
  void Reload();

  // The robot that calls: by its token, else its client certificate, else as it calls itself
  // (RobotName). Throws Unauthenticated where a token is needed and does not do,
  // std::invalid_argument for a name that does not.
  RobotId Admit(const grpc::ServerContextBase& context) const;

  // Whether tokens are needed and there is none.
  bool RefusesEverybody() const;

 private:
  std::shared_ptr<const TokenTable> Table() const;

  const std::string tokens_;
  mutable std::mutex mutex_;
  std::shared_ptr<const TokenTable> table_;
};

}  // namespace fovea::server
