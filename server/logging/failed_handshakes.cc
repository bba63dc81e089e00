#include "server/logging/failed_handshakes.h"

#include <deque>
#include <mutex>

namespace fovea::server {
namespace {

class FailedHandshakes {
 public:
  void Note(HandshakeClock::time_point now) {
    const std::lock_guard lock(mutex_);
    Forget(now);
    noted_.push_back(now);
  }
  bool Take(HandshakeClock::time_point now) {
    const std::lock_guard lock(mutex_);
    Forget(now);
    if (noted_.empty()) return false;
    noted_.pop_front();
    return true;
  }

 private:
  void Forget(HandshakeClock::time_point now) {
    constexpr std::chrono::seconds kKept{1};
    while (!noted_.empty() && now - noted_.front() >= kKept) noted_.pop_front();
  }

  std::mutex mutex_;
  std::deque<HandshakeClock::time_point> noted_;  // oldest first
};

FailedHandshakes& AllFailedHandshakes() {
  static auto* const handshakes = new FailedHandshakes;  // gRPC's threads may log at the very end
  return *handshakes;
}

}  // namespace

void NoteFailedHandshake(HandshakeClock::time_point now) { AllFailedHandshakes().Note(now); }

bool TakeFailedHandshake(HandshakeClock::time_point now) { return AllFailedHandshakes().Take(now); }

}  // namespace fovea::server
