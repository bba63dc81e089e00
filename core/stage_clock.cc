#include "core/stage_clock.h"

namespace fovea {

void StageClock::Finish() {
  times_.push_back({stage_, SinceBegin()});
  started_ = Clock::now();
  scope_.AskNow();
}

void StageClock::Begin(const std::string& stage) {
  Finish();
  stage_ = stage;
  scope_.Enter(stage);
}

std::vector<StageTime> StageClock::TimesUntilNow() const {
  std::vector<StageTime> times = times_;
  if (times.empty() || times.back().stage != stage_) times.push_back({stage_, SinceBegin()});
  return times;
}

double StageClock::SinceBegin() const {
  return std::chrono::duration<double, std::milli>(Clock::now() - started_).count();
}

}  // namespace fovea
