#include "server/rpc/event_loop.h"

#include <utility>

#include "server/log_exception.h"

namespace fovea::server {

EventLoop::EventLoop(std::unique_ptr<grpc::ServerCompletionQueue> queue)
    : queue_(std::move(queue)), thread_([this] { Run(); }) {}

EventLoop::~EventLoop() { queue_->Shutdown(); }

void EventLoop::Run() {
  void* tag = nullptr;
  bool ok = false;
  while (queue_->Next(&tag, &ok)) {
    auto* event = static_cast<CallEvent*>(tag);
    event->started.load(std::memory_order_acquire);
    // Moved out, since it may hold the last reference to the call that the event is part of.
    const auto then = std::move(event->then);
    if (event->owned_by_loop) delete event;
    try {
      if (then) then(ok);
    } catch (...) {  // what belongs to a call has ended that; see Caller::Guard
      LogCurrentException("an event was not handled");
    }
  }
}

}  // namespace fovea::server
