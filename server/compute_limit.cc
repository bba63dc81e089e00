#include "server/compute_limit.h"

#include <ctime>

#include "core/types/helpers.h"

namespace fovea::server {

std::chrono::nanoseconds ComputeLimit::Used() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec) +
         Helpers::Waited();
}

}  // namespace fovea::server
