// Memory that the server does not use goes back to the system.
#pragma once

#include <chrono>
#include <thread>

namespace fovea::server {

// Gives back to the system, once a period as long as it lives, what malloc keeps and nobody has
// used since: else memory is what the worst moment ever took, and each new worst adds to it. What
// the next frame needs again it takes again; that costs some milliseconds a period.
class SpareMemory {
 public:
  explicit SpareMemory(std::chrono::milliseconds period);

 private:
  std::jthread thread_;
};

}  // namespace fovea::server
