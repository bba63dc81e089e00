// Bounds how many frames are decoded and computed at once, and with that memory and load.
#pragma once

#include <functional>
#include <memory>
#include <semaphore>

namespace fovea::server {

class ComputeSlots {
 public:
  // `count` must be positive.
  explicit ComputeSlots(int count) : semaphore_(count) {}

  struct Release {
    void operator()(std::counting_semaphore<>* semaphore) const { semaphore->release(); }
  };
  // Gives the slot back when it goes.
  using Slot = std::unique_ptr<std::counting_semaphore<>, Release>;

  // Waits for a slot. `should_stop` is asked while waiting; throws Cancelled once it is true.
  Slot Acquire(const std::function<bool()>& should_stop);

 private:
  std::counting_semaphore<> semaphore_;
};

}  // namespace fovea::server
