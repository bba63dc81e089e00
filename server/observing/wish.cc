#include "server/observing/wish.h"

#include <cmath>

#include "server/access/unauthenticated.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr double kUsualRateHz = 2, kMaxRateHz = 30, kMinRateHz = 0.001;
constexpr int kMaxPatterns = 64;
constexpr std::size_t kMaxPatternBytes = 1024;  // names of certificates are long, escaped even more

std::chrono::steady_clock::duration PeriodOf(double rate_hz) {
  if (rate_hz == 0) rate_hz = kUsualRateHz;
  RequireField(std::isfinite(rate_hz) && rate_hz >= kMinRateHz && rate_hz <= kMaxRateHz,
               "max_rate_hz", "must be 0, or 0.001 to 30");
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(1 / rate_hz));
}

}  // namespace

bool Wish::Covers(const std::string& robot) const {
  return observer.MaySee(robot) && (robots.empty() || MatchesAny(robots, robot));
}

Wish WishOf(const v1::WatchRequest& request, const ObserverEntry& observer) {
  Wish wish{.observer = observer,
            .robots = {request.robots().begin(), request.robots().end()},
            .period = PeriodOf(request.max_rate_hz()),
            .only_problems = request.only_problems()};
  RequireField(request.robots_size() <= kMaxPatterns, "robots", "must be at most 64");
  for (const std::string& pattern : wish.robots) {
    RequireField(!pattern.empty() && pattern.size() <= kMaxPatternBytes, "robots",
                 "must each have 1 to 1024 characters");
  }
  for (const int part : request.parts()) {
    RequireField(part > v1::WATCH_PART_UNSPECIFIED && v1::WatchPart_IsValid(part), "parts",
                 "holds " + std::to_string(part) + ", which is no WatchPart");
    wish.parts |= Bit(static_cast<v1::WatchPart>(part));
  }
  if ((wish.parts & Bit(v1::WATCH_PART_FRAME)) != 0 && !observer.rights.download) {
    throw PermissionDenied("parts: WATCH_PART_FRAME needs the right download");
  }
  return wish;
}

}  // namespace fovea::server
