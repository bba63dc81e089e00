#include "core/types/interruption.h"

#include <utility>

#include "core/types/cancelled.h"

namespace fovea {

namespace internal {
constinit thread_local InterruptionScope* interruption_scope = nullptr;
}  // namespace internal

InterruptionScope::InterruptionScope(std::function<bool()> should_stop,
                                     std::chrono::microseconds period)
    : should_stop_(std::move(should_stop)),
      period_(period),
      next_(Clock::now() + period),
      outer_(std::exchange(internal::interruption_scope, this)) {}

InterruptionScope::~InterruptionScope() { internal::interruption_scope = outer_; }

void InterruptionScope::Ask() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + period_;
  AskNow();
}

void InterruptionScope::AskNow() {
  if (should_stop_ && should_stop_()) throw Cancelled(stage_);
}

}  // namespace fovea
