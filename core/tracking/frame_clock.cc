#include "core/tracking/frame_clock.h"

#include <algorithm>
#include <utility>

namespace fovea {
namespace {

// That are counted: nothing stands still for long.
constexpr double kShortestStep_s = 0.01, kLongestStep_s = 1 / FrameClock::kFramesPerSecond;

double Seconds(const CaptureTime& from, const CaptureTime& to) {
  return static_cast<double>(to.seconds - from.seconds) + 1e-9 * (to.nanos - from.nanos);
}

}  // namespace

double FrameClock::Add(const std::optional<CaptureTime>& time) {
  const std::optional<CaptureTime> last = std::exchange(last_, time);
  if (!time || (latest_ && *time <= *latest_)) {
    const bool was_set_back = time && last && *last < *time && *last < *latest_ && *time < *latest_;
    if (!was_set_back) {
      counted_s_ += step_s_;
      return step_s_;
    }
    latest_ = time;
    counted_s_ = 0;
    return Seconds(*last, *time);
  }
  const double step_s = latest_ ? Seconds(*latest_, *time) : kLongestStep_s;
  const double seconds = std::max(0.0, step_s - counted_s_);
  step_s_ = std::clamp(step_s, kShortestStep_s, kLongestStep_s);
  latest_ = time;
  counted_s_ = 0;
  return seconds;
}

}  // namespace fovea
