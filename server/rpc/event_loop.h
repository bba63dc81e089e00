// Asynchronous gRPC: operations are started with a CallEvent as their tag, and what follows from
// them runs on the event loop's thread.
#pragma once

#include <grpcpp/completion_queue.h>

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace fovea::server {

// `then` is called once, with what gRPC says of the operation: whether it did what it should.
struct CallEvent {
  std::function<void(bool ok)> then;
  bool owned_by_loop = false;
  // Orders what the starting thread did before what follows. gRPC's queue does so too, but not
  // where ThreadSanitizer sees it, as Debian's is built without.
  std::atomic<bool> started = false;
};

// A tag for an operation that is sure to complete once started.
inline void* Then(std::function<void(bool ok)> then) {
  auto* event = new CallEvent{.then = std::move(then), .owned_by_loop = true};
  event->started.store(true, std::memory_order_release);
  return event;
}

class EventLoop {
 public:
  explicit EventLoop(std::unique_ptr<grpc::ServerCompletionQueue> queue);
  // Nothing may be started any more; waits for what was.
  ~EventLoop();

  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  grpc::ServerCompletionQueue* queue() { return queue_.get(); }

 private:
  void Run();

  const std::unique_ptr<grpc::ServerCompletionQueue> queue_;
  std::jthread thread_;
};

}  // namespace fovea::server
