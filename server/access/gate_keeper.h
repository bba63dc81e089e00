#pragma once

#include <grpcpp/server_context.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "server/access/client_authority.h"
#include "server/access/token_table.h"
#include "server/scheduling/robot_id.h"

namespace fovea::server {

// That a call was let in, and how long that holds.
struct Admission {
  RobotId robot;
  std::chrono::sys_seconds expires = std::chrono::sys_seconds::max();
  std::uint64_t rules = 0;  // those that it was let in by
};

// Lets calls in and knows who they are. Thread-safe.
class GateKeeper {
 public:
  // `tokens` is a file for TokenTable, or empty: then all that connect may call. `authority` is
  // that of the clients' certificates, null where they need none.
  explicit GateKeeper(std::string tokens,
                      std::shared_ptr<const ClientAuthority> authority = nullptr);

  // Takes over what the file holds now. Throws like TokenTable::FromFile, and std::invalid_argument
  // where it holds no token any more that has not expired; changes nothing then.
  void Reload();
  void SetAuthority(std::shared_ptr<const ClientAuthority> authority);

  // The robot that calls: by its token, else its client certificate, else as it calls itself
  // (RobotName). Throws Unauthenticated where a token or a certificate is needed and does not do,
  // std::invalid_argument for a name that does not.
  Admission Admit(const grpc::ServerContextBase& context) const;

  // Throws like Admit where a call that was let in would not be any more, or be somebody else's.
  // Leaves the robot as it is, which others may read meanwhile. Costs next to nothing as long as
  // neither the rules have changed nor its time has come.
  void Readmit(const grpc::ServerContextBase& context, Admission* admission) const;

  // Whether tokens are needed and there is none that has not expired.
  bool RefusesEverybody() const;

  // Says in the log how many tokens there are, and whose have expired or soon will; where none has,
  // only if `also_good`.
  void LogTokens(bool also_good) const;

 private:
  struct Rules {
    std::uint64_t number = 0;  // another one for each change
    std::shared_ptr<const TokenTable> tokens;
    std::shared_ptr<const ClientAuthority> authority;
  };

  Rules rules() const;

  const std::string tokens_;
  mutable std::mutex mutex_;
  Rules rules_;
};

}  // namespace fovea::server
