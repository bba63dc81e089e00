#include "core/stage_clock.h"

#include "core/types/cancelled.h"

namespace fovea {

void StageClock::Finish(const std::string& stage) {
  const Clock::time_point now = Clock::now();
  times_.push_back({stage, std::chrono::duration<double, std::milli>(now - started_).count()});
  if (should_stop_ && should_stop_()) throw Cancelled();
  started_ = now;
}

}  // namespace fovea
