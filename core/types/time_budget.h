// How long a detection may take.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "core/types/cancelled.h"

namespace fovea {

class TimeBudget {
 public:
  using Clock = std::chrono::steady_clock;

  // From now on. 0: as long as it takes. `should_stop` (may be empty): whether the caller wants no
  // answer at all. `now`: what tells the time.
  TimeBudget(std::chrono::duration<double, std::milli> budget, std::function<bool()> should_stop,
             std::function<Clock::time_point()> now = Clock::now)
      : now_(std::move(now)),
        is_limited_(budget.count() > 0),
        begin_(now_()),
        end_(begin_ + std::chrono::duration_cast<Clock::duration>(budget)),
        should_stop_(std::move(should_stop)) {}

  // Whether to go on is asked; for an InterruptionScope.
  bool WantsStop() {
    is_stopped_ = is_stopped_ || (should_stop_ && should_stop_());
    return is_stopped_ || HasEnded();
  }
  // Ends it by this share of it sooner: for what is left to do once it has ended.
  void KeepBack(double share) {
    end_ -= std::chrono::duration_cast<Clock::duration>(share * (end_ - begin_));
  }
  // Whether what is left of it is more than so many times what has been used.
  bool HasMoreLeftThan(double times) const {
    const Clock::time_point now = now_();
    return !is_limited_ || end_ - now > times * (now - begin_);
  }
  // Works; whether that ended before the budget did, which is lifted otherwise, for what is left to
  // do. Throws Cancelled where the caller wants no more.
  bool Suffices(const std::function<void()>& work) {
    try {
      work();
      return true;
    } catch (const Cancelled&) {
      if (is_stopped_) throw;  // by the caller
      Lift();
      return false;
    }
  }
  bool HasEnded() const { return is_limited_ && now_() >= end_; }
  // For what is left to do once it has ended.
  void Lift() { is_limited_ = false; }

 private:
  std::function<Clock::time_point()> now_;
  bool is_limited_;
  bool is_stopped_ = false;
  Clock::time_point begin_, end_;
  std::function<bool()> should_stop_;
};

}  // namespace fovea
