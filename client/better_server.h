#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "client/client_options.h"
#include "client/server_load.h"
#include "client/servers.h"

namespace fovea::client {

// Looks now and then whether a stream would get more answers at another server. Not thread-safe.
class BetterServer {
 public:
  // Servers are asked after `shortest` at the earliest, and a bit more than twice that at the
  // latest. `timeout`: how long each has to answer.
  BetterServer(Servers& servers, const ClientOptions& options,
               std::chrono::milliseconds shortest = std::chrono::seconds(3),
               std::chrono::milliseconds timeout = std::chrono::milliseconds(200));

  // A server where a stream at `own` would be answered much more often; null where there is none
  // that is known, and most times, since servers are asked every few seconds only. That takes some
  // milliseconds, and the timeout for each that does not answer.
  Servers::Pointer Find(const Servers::Pointer& own);

 private:
  void PlanNext();
  bool Ask(const Server& server);

  Servers& servers_;
  const ClientOptions& options_;
  const std::chrono::milliseconds shortest_, timeout_;
  std::minstd_rand random_;
  Servers::Clock::time_point next_;
  std::map<std::string, ServerLoad> loads_;  // by name
};

}  // namespace fovea::client
