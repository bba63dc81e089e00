// Times the stages of the pipeline and lets them be stopped.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/types/detections.h"
#include "core/types/interruption.h"

namespace fovea {

class StageClock {
 public:
  // The first stage begins. Appends to `times`; asks `should_stop` (may be empty) at the
  // interruption points of this thread and after each stage.
  StageClock(std::vector<StageTime>& times, std::function<bool()> should_stop,
             const std::string& first_stage)
      : times_(times), scope_(std::move(should_stop)), stage_(first_stage) {
    scope_.Enter(first_stage);
  }

  // Ends a stage, and begins the next one. Throw Cancelled if the caller wants to stop.
  void Finish();
  void Begin(const std::string& stage);

  // Of the stages that have ended, and of the one that has not.
  std::vector<StageTime> TimesUntilNow() const;

 private:
  using Clock = std::chrono::steady_clock;

  double SinceBegin() const;  // ms

  std::vector<StageTime>& times_;
  InterruptionScope scope_;
  std::string stage_;
  Clock::time_point started_ = Clock::now();
};

}  // namespace fovea
