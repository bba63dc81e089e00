#include "tests/load/stop_signals.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>

namespace fovea::load {

StopSignals::StopSignals() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
}

bool StopSignals::ComeUntil(std::chrono::steady_clock::time_point time) const {
  constexpr std::int64_t kPerSecond = 1'000'000'000;
  for (;;) {
    const std::chrono::nanoseconds left = time - std::chrono::steady_clock::now();
    const std::int64_t wait = std::max<std::int64_t>(left.count(), 0);
    const timespec timeout = {wait / kPerSecond, wait % kPerSecond};
    if (sigtimedwait(&signals_, nullptr, &timeout) > 0) return true;
    if (errno == EAGAIN) return false;  // else another signal was handled
  }
}

}  // namespace fovea::load
