#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "client/server_address.h"

namespace fovea::client {

// What addresses stand for, looked up in the background since that may take many seconds, and again
// when asked for. Without names it is known at once and for good. Thread-safe.
class NameLookup {
 public:
  using Clock = std::chrono::steady_clock;

  explicit NameLookup(std::vector<ServerAddress> addresses);

  // Looks names up again, unless that was done in the last seconds.
  void Refresh();

  // What was found last; waits where that is nothing. `problem` says why there is none then.
  FoundTargets Get(Clock::time_point deadline);

 private:
  struct State;

  const std::shared_ptr<State> state_;
};

}  // namespace fovea::client
