#include "core/stage_clock.h"

#include <algorithm>

#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Stages that come again count as one.
void Add(const StageTime& time, std::vector<StageTime>& times) {
  constexpr std::size_t kUsualStages = 16;
  times.reserve(kUsualStages);
  const auto known = std::find_if(times.begin(), times.end(), [&](const StageTime& other) {
    return other.stage == time.stage;
  });
  if (known == times.end()) {
    times.push_back(time);
  } else {
    known->duration_ms += time.duration_ms;
  }
}

}  // namespace

StageClock::StageClock(const std::string& first_stage) : stage_(first_stage) {
  EnterStage(first_stage);
}

void StageClock::Finish() {
  if (stage_.empty()) return;
  Add({stage_, SinceBegin()}, times_);
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
  tasks.reserve(branches.size());
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
    for (const StageTime& time : branch.TimesUntilNow()) Add(time, times);
  }
  if (!stage_.empty()) Add({stage_, SinceBegin()}, times);
  return times;
}

double StageClock::SinceBegin() const {
  return std::chrono::duration<double, std::milli>(Clock::now() - started_).count();
}

}  // namespace fovea
