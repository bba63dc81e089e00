#include "client/observer/ending_threads.h"

#include <list>
#include <mutex>
#include <utility>

namespace fovea::observer {
namespace {

struct EndingThread {
  std::shared_ptr<const std::atomic<bool>> has_ended;
  std::jthread thread;  // joins
};

struct EndingThreads {
  std::mutex mutex;
  std::list<EndingThread> threads;
};

}  // namespace

void LeaveToEnd(std::jthread thread, std::shared_ptr<const std::atomic<bool>> has_ended) {
  static EndingThreads ending;
  thread.request_stop();
  const std::lock_guard lock(ending.mutex);
  std::erase_if(ending.threads, [](const EndingThread& each) { return each.has_ended->load(); });
  ending.threads.push_back({std::move(has_ended), std::move(thread)});
}

}  // namespace fovea::observer
