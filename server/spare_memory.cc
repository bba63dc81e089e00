#include "server/spare_memory.h"

#include <malloc.h>

#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace fovea::server {

SpareMemory::SpareMemory(std::chrono::milliseconds period)
    : thread_([period](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        while (!never.wait_for(lock, stop, period, [&] { return stop.stop_requested(); })) {
          malloc_trim(0);
        }
      }) {}

}  // namespace fovea::server
