#include "core/tracking/frame_clock.h"

#include <algorithm>
#include <utility>

namespace fovea {
namespace {

constexpr double kUsual_s = 1 / FrameClock::kFramesPerSecond;

double Seconds(const CaptureTime& from, const CaptureTime& to) {
  return static_cast<double>(to.seconds - from.seconds) + 1e-9 * (to.nanos - from.nanos);
}

}  // namespace

double FrameClock::Add(const std::optional<CaptureTime>& time) {
  const std::optional<CaptureTime> last = std::exchange(last_, time);
  if (!time || (latest_ && *time <= *latest_)) {
    const bool was_set_back = time && last && *last < *time && *last < *latest_ && *time < *latest_;
    if (!was_set_back) {
      counted_s_ += kUsual_s;
      return kUsual_s;
    }
    latest_ = time;
    counted_s_ = 0;
    return Seconds(*last, *time);
  }
  const double seconds = latest_ ? std::max(0.0, Seconds(*latest_, *time) - counted_s_) : kUsual_s;
  latest_ = time;
  counted_s_ = 0;
  return seconds;
}

}  // namespace fovea
