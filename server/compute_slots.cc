#include "server/compute_slots.h"

#include <chrono>

#include "core/detector.h"

namespace fovea::server {

ComputeSlots::Slot ComputeSlots::Acquire(const std::function<bool()>& should_stop) {
  // A slot that gets free wakes the waiter at once; the interval is how late it sees a caller go.
  constexpr auto kAskInterval = std::chrono::milliseconds(10);
  do {
    if (should_stop()) throw Cancelled();
  } while (!semaphore_.try_acquire_for(kAskInterval));
  return Slot(&semaphore_);
}

}  // namespace fovea::server
