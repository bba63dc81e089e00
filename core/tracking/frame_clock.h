// How much time passes between frames, by what they say of it.
#pragma once

#include <optional>

#include "core/types/track.h"

namespace fovea {

// By the latest time that a frame had. One without a time, or with one that is not after that,
// counts as the last step between such times, 0.01 s to 1 / kFramesPerSecond, which is taken off
// the next step: late frames, or some without time, pass no faster or slower than the others. Two
// in turn that are before the latest and go on from each other are a clock that was set back, and
// hold from then on.
class FrameClock {
 public:
  static constexpr double kFramesPerSecond = 10;

  // Seconds since the frame before: 0 or more. The first one's mean nothing.
  double Add(const std::optional<CaptureTime>& time);

 private:
  std::optional<CaptureTime> latest_, last_;
  double counted_s_ = 0;  // since the latest
  double step_s_ = 1 / kFramesPerSecond;
};

}  // namespace fovea
