#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "server/access/credentials.h"
#include "server/access/gate_keeper.h"
#include "server/access/observer_gate.h"

namespace fovea::server {

// Keeps up with who may call: reads the certificates again every `period`, or every second as long
// as they cannot be used, says at first and once a day what has expired or soon will, and has the
// calls under way checked once a second, since what lets them in may expire.
class AccessWatch {
 public:
  // `check_calls` is called from a thread of its own; all must outlive this.
  AccessWatch(std::chrono::seconds period, Credentials& credentials, GateKeeper& gate_keeper,
              const ObserverGate& observer_gate, std::function<void()> check_calls);

 private:
  void Run(const std::stop_token& stop);
  void Look();
  void Remind();
  void Reload();

  const std::chrono::seconds period_;
  Credentials& credentials_;
  GateKeeper& gate_keeper_;
  const ObserverGate& observer_gate_;
  const std::function<void()> check_calls_;
  std::chrono::steady_clock::time_point reloaded_;
  std::optional<std::chrono::steady_clock::time_point> reminded_;  // none: it is due
  std::string fault_;  // of the files, as it was said last; empty = none
  std::jthread thread_;
};

}  // namespace fovea::server
