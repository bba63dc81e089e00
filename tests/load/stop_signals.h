// Ends a run early, with a report.
#pragma once

#include <signal.h>

#include <chrono>

namespace fovea::load {

// SIGINT and SIGTERM end nothing once this is made, in this thread and those that begin later: they
// wait until they are asked for.
class StopSignals {
 public:
  StopSignals();

  // Waits until then, or until one comes; whether one did.
  bool ComeUntil(std::chrono::steady_clock::time_point time) const;

 private:
  sigset_t signals_;
};

}  // namespace fovea::load
