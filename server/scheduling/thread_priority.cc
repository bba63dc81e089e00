#include "server/scheduling/thread_priority.h"

#include <sys/resource.h>

#include <algorithm>

namespace fovea::server {
namespace {

constexpr int kNicest = 19;

}  // namespace

// On Linux niceness belongs to the thread, and 0 is the one that asks. Being nicer is always
// allowed.
void LowerPriority(int steps) {
  setpriority(PRIO_PROCESS, 0, std::min(kNicest, getpriority(PRIO_PROCESS, 0) + steps));
}

}  // namespace fovea::server
