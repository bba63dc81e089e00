#include "server/connections/flood_guard.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>

#include "server/connections/begun_calls.h"
#include "server/logging/log_limiter.h"

namespace fovea::server {
namespace {

// Of the whole server: a thousand robots do not make as many, and the event loop takes more.
constexpr double kCalls_s = 5000;
constexpr double kMaxBudget = 2 * kCalls_s, kMinBudget = -kCalls_s;
// Of a connection, before and after that is too much. A robot may have all of its calls end and
// begin again when its deadlines pass, be these of some milliseconds.
constexpr std::uint64_t kMaxCalls_s = 4000, kMaxCallsInFlood_s = 500;
// What is less is not looked at by connection.
constexpr double kQuiet_s = 1000, kFew = 32;

}  // namespace

FloodGuard::FloodGuard(ConnectionTable& connections)
    : connections_(connections),
      looked_(Clock::now()),
      begun_(NumBegunCalls()),
      budget_(kMaxBudget) {}

void FloodGuard::Inspect(Clock::time_point now) {
  try {
    const std::uint64_t begun = NumBegunCalls();
    const auto more = static_cast<double>(begun - std::min(begun, begun_));
    const double seconds = std::chrono::duration<double>(now - looked_).count();
    begun_ = begun;
    looked_ = now;
    budget_ = std::clamp(budget_ + seconds * kCalls_s - more, kMinBudget, kMaxBudget);
    if (more > std::max(seconds * kQuiet_s, kFew)) {
      connections_.OnBegunCalls(BegunCallsByConnection(),
                                IsFlooded() ? kMaxCallsInFlood_s : kMaxCalls_s);
    }
  } catch (const std::exception& error) {
    LogLimited("calls not counted", spdlog::level::err,
               std::string("cannot count calls: ") + error.what());
  }
}

}  // namespace fovea::server
