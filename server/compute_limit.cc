#include "server/compute_limit.h"

#include <algorithm>
#include <ctime>

#include "core/types/helpers.h"

namespace fovea::server {

std::chrono::nanoseconds ComputeLimit::Used() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec) +
         Helpers::Waited();
}

std::chrono::nanoseconds ComputeLimit::WaitedForProcessor() const {
  const std::chrono::nanoseconds passed = std::chrono::steady_clock::now() - began_;
  return std::max(passed - (Used() - start_), std::chrono::nanoseconds(0));
}

}  // namespace fovea::server
