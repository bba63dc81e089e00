// Times the stages of the pipeline and stops it between them.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

class StageClock {
 public:
  // Appends to `times`; asks `should_stop` (may be empty) after each stage.
  StageClock(std::vector<StageTime>& times, std::function<bool()> should_stop)
      : times_(times), should_stop_(std::move(should_stop)) {}

  // Ends a stage that began at the end of the one before. Throws Cancelled if the caller wants to
  // stop.
  void Finish(const std::string& stage);

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime>& times_;
  std::function<bool()> should_stop_;
  Clock::time_point started_ = Clock::now();
};

}  // namespace fovea
