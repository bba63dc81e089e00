#include "core/stage_clock.h"

#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {

StageClock::StageClock(const std::string& first_stage) : stage_(first_stage) {
  EnterStage(first_stage);
}

void StageClock::Finish() {
  if (stage_.empty()) return;
  times_.push_back({stage_, SinceBegin()});
  stage_.clear();
  InterruptionPointNow();
}

void StageClock::Begin(const std::string& stage) {
  Finish();
  stage_ = stage;
  started_ = Clock::now();
  EnterStage(stage);
}

void StageClock::RunBranches(const std::vector<Branch>& branches) {
  Finish();
  std::vector<Task> tasks;
  for (const Branch& branch : branches) {
    StageClock& clock = branches_.emplace_back("");
    tasks.emplace_back([&branch, &clock] {
      clock.Begin(branch.first_stage);
      branch.run(clock);
      clock.Finish();
    });
  }
  RunTogether(tasks);
  times_ = TimesUntilNow();
  branches_.clear();
}

std::vector<StageTime> StageClock::TimesUntilNow() const {
  std::vector<StageTime> times = times_;
  for (const StageClock& branch : branches_) {
    const std::vector<StageTime> more = branch.TimesUntilNow();
    times.insert(times.end(), more.begin(), more.end());
  }
  if (!stage_.empty()) times.push_back({stage_, SinceBegin()});
  return times;
}

double StageClock::SinceBegin() const {
  return std::chrono::duration<double, std::milli>(Clock::now() - started_).count();
}

}  // namespace fovea
