// Times the stages of the pipeline and lets them be stopped.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <string>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

class StageClock {
 public:
  // The first stage begins.
  explicit StageClock(const std::string& first_stage);

  // Ends a stage, and begins the next one. Throw Cancelled if the caller wants to stop.
  void Finish();
  void Begin(const std::string& stage);

  // Stages that do not need those of other branches, with a clock of their own that has begun the
  // first one.
  struct Branch {
    std::string first_stage;
    std::function<void(StageClock&)> run;
  };
  // Ends a stage and runs the branches, side by side where this thread is helped (helpers.h). Their
  // stages count one branch after the other. The next stage begins with Begin().
  void RunBranches(const std::vector<Branch>& branches);

  // Of the stages that have ended, and of those that have not.
  std::vector<StageTime> TimesUntilNow() const;

 private:
  using Clock = std::chrono::steady_clock;

  double SinceBegin() const;  // ms

  std::vector<StageTime> times_;
  std::string stage_;  // that runs; empty: none
  Clock::time_point started_ = Clock::now();
  std::list<StageClock> branches_;  // that run
};

}  // namespace fovea
