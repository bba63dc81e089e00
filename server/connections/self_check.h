#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "server/connections/door.h"

namespace fovea::server {

// Asks the server for its health as a caller does, by a connection through its own door: whatever
// in the process keeps callers from being heard keeps this from being answered.
class SelfCheck {
 public:
  // `on_answer` is called after each check that was answered, `on_failure` once, after three in a
  // row that were not, with what the last one came to.
  struct Listener {
    std::function<void()> on_answer;
    std::function<void(const std::string& why)> on_failure;
  };

  // The first check is made at once. `door` must be open as long as this lives.
  SelfCheck(Door& door, std::chrono::seconds period, Listener listener);

  // Whether the last check was answered, or none was made yet.
  bool is_live() const { return failures_ == 0; }

 private:
  void Run(const std::stop_token& stop);
  void Check();

  Door& door_;
  const std::chrono::seconds period_;
  const Listener listener_;
  std::atomic<int> failures_ = 0;
  std::jthread thread_;
};

}  // namespace fovea::server
