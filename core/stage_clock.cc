#include "core/stage_clock.h"

namespace fovea {

void StageClock::Finish() {
  const Clock::time_point now = Clock::now();
  times_.push_back({stage_, std::chrono::duration<double, std::milli>(now - started_).count()});
  scope_.AskNow();
  started_ = now;
}

void StageClock::Begin(const std::string& stage) {
  Finish();
  stage_ = stage;
  scope_.Enter(stage);
}

}  // namespace fovea
