#include "core/tracking/frame_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace fovea {
namespace {

constexpr double kNone = -1;

// The sum of what passes after the first of frames that have these times, in tenths of a second.
double TenthsOf(const std::vector<double>& times) {
  FrameClock clock;
  double sum_s = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::optional<CaptureTime> time;
    if (times[i] != kNone) {
      const double whole = std::floor(times[i] / 10);
      time = {static_cast<std::int64_t>(whole),
              static_cast<std::int32_t>(std::lround((times[i] / 10 - whole) * 1e9))};
    }
    const double seconds = clock.Add(time);
    EXPECT_GE(seconds, 0);
    if (i > 0) sum_s += seconds;
  }
  return 10 * sum_s;
}

TEST(FrameClock, GoesByTheTimesOfFrames) { EXPECT_NEAR(TenthsOf({10, 12, 15, 600}), 590, 1e-6); }

TEST(FrameClock, CountsFramesWithoutTimes) {
  EXPECT_NEAR(TenthsOf({kNone, kNone, kNone}), 2, 1e-6);
  EXPECT_NEAR(TenthsOf({7, 7, 7, 7}), 3, 1e-6);
}

TEST(FrameClock, SomeWithoutTimesDoNotStopIt) {
  EXPECT_NEAR(TenthsOf({10, kNone, 20, kNone, 30, kNone, 40}), 30, 1e-6);
}

TEST(FrameClock, FramesInDisorderPassAsFastAsOthers) {
  EXPECT_NEAR(TenthsOf({10, 12, 11, 14, 13, 16, 15, 17}), 7, 1e-6);
}

TEST(FrameClock, AStrayTimeDoesNotMoveIt) {
  EXPECT_NEAR(TenthsOf({1000, 1001, 0, 1002, 1003}), 3, 1e-6);
}

// Thirty a second.
TEST(FrameClock, FastFramesPassAsFastWithoutTimesOrLate) {
  const double f = 1.0 / 3;
  EXPECT_NEAR(TenthsOf({30, 30 + f, 30 + 2 * f, kNone, 30 + 4 * f, kNone, 30 + 6 * f}), 2, 0.01);
  EXPECT_NEAR(TenthsOf({30, 30 + 2 * f, 30 + f, 30 + 4 * f, 30 + 3 * f, 30 + 6 * f}), 2, 0.01);
  EXPECT_NEAR(TenthsOf({30, 30 + 2 * f, 30 + 2 * f, 30 + 4 * f, 30 + 4 * f, 30 + 6 * f}), 2, 0.01);
}

TEST(FrameClock, GoesOnThoughTheStepBeforeWasNothing) {
  EXPECT_GE(TenthsOf({30, 30 + 1e-8, kNone, kNone, kNone}), 0.3);
}

// The first that is back counts as a frame without time.
TEST(FrameClock, MayBeSetBack) {
  EXPECT_NEAR(TenthsOf({1000, 1005, 10, 15, 20, 25}), 5 + 1 + 15, 1e-6);
}

}  // namespace
}  // namespace fovea
