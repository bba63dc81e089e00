// A detection can be told to stop in the midst of its stages, without each function passing on whom
// to ask.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace fovea {

// From its making to its end, what runs on this thread asks at its interruption points whether to
// stop. Scopes may be nested; the inner one holds.
class InterruptionScope {
 public:
  // `should_stop` (may be empty: never) is asked no more often than once a `period`.
  explicit InterruptionScope(std::function<bool()> should_stop,
                             std::chrono::microseconds period = std::chrono::milliseconds(1));
  ~InterruptionScope();

  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  void Enter(std::string stage) { stage_ = std::move(stage); }

  // Throws Cancelled, with the stage, if it should stop; `Now` asks whatever the period.
  void Ask();
  void AskNow();

 private:
  using Clock = std::chrono::steady_clock;

  const std::function<bool()> should_stop_;
  const std::chrono::microseconds period_;
  Clock::time_point next_;
  std::string stage_;
  InterruptionScope* const outer_;
};

namespace internal {
// Of this thread; null where nobody can stop it. Constant from the start, so that no function is
// called to look at it.
extern constinit thread_local InterruptionScope* interruption_scope;
}  // namespace internal

// Throws Cancelled where the scope of this thread wants to stop. Long loops call it, at least once
// in some milliseconds; it takes some 30 ns, which is one look at the clock.
inline void InterruptionPoint() {
  if (internal::interruption_scope != nullptr) internal::interruption_scope->Ask();
}

// The same whatever the period.
inline void InterruptionPointNow() {
  if (internal::interruption_scope != nullptr) internal::interruption_scope->AskNow();
}

// What begins now on this thread; whoever is stopped says so.
inline void EnterStage(const std::string& stage) {
  if (internal::interruption_scope != nullptr) internal::interruption_scope->Enter(stage);
}

// For loops of many short turns: a point at every 256th of them.
class LongLoop {
 public:
  void Turn() {
    if (++turns_ % 256 == 0) InterruptionPoint();
  }

 private:
  unsigned turns_ = 0;
};

}  // namespace fovea
