#include "server/number_ranges.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <variant>

namespace fovea::server {
namespace {

struct NumberRange {
  const char* flag;
  std::variant<int ServerOptions::*, std::int64_t ServerOptions::*> number;
  std::int64_t minimum, maximum;

  std::int64_t Of(const ServerOptions& options) const {
    return std::visit([&](auto member) { return std::int64_t{options.*member}; }, number);
  }

  bool CanHold(std::int64_t value) const {
    return std::holds_alternative<std::int64_t ServerOptions::*>(number) ||
           (value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max());
  }

  std::string Text() const {
    return "between " + std::to_string(minimum) + " and " + std::to_string(maximum);
  }
};

using Options = ServerOptions;

constexpr std::array kRanges{
    NumberRange{"--tls-reload-s", &Options::tls_reload_s, 1, 86'400},
    NumberRange{"--max-streams", &Options::max_streams, 1, 10'000},
    NumberRange{"--max-streams-per-robot", &Options::max_streams_per_robot, 1, 10'000},
    NumberRange{"--max-streams-per-host", &Options::max_streams_per_host, 0, 10'000},
    NumberRange{"--max-connections", &Options::max_connections, 1, 100'000},
    NumberRange{"--max-connections-per-host", &Options::max_connections_per_host, 0, 100'000},
    NumberRange{"--max-receiving-mib", &Options::max_receiving_mib, 16, 65'536},
    NumberRange{"--max-unsent-mib", &Options::max_unsent_mib, 16, 65'536},
    NumberRange{"--max-transfer-s", &Options::max_transfer_s, 1, 3600},
    NumberRange{"--self-check-s", &Options::self_check_s, 0, 3600},
    NumberRange{"--max-idle-s", &Options::max_idle_s, 1, 86'400},
    NumberRange{"--max-connection-age-s", &Options::max_connection_age_s, 0, 86'400},
    NumberRange{"--max-message-mib", &Options::max_message_mib, 1, 1024},
    NumberRange{"--max-pixels", &Options::max_pixels, 1, 100'000'000},
    NumberRange{"--compute-threads", &Options::compute_threads, 0, 1024},
    NumberRange{"--threads-per-frame", &Options::threads_per_frame, 0, 1024},
    NumberRange{"--compute-nice", &Options::compute_nice, 0, 19},
    NumberRange{"--max-waiting", &Options::max_waiting, -1, 10'000},
    NumberRange{"--max-per-robot", &Options::max_per_robot, 0, 10'000},
    NumberRange{"--max-running-per-robot", &Options::max_running_per_robot, 0, 1024},
    NumberRange{"--max-compute-ms", &Options::max_compute_ms, 0, 3'600'000},
    NumberRange{"--hold-s", &Options::hold_s, 0, 3600},
    NumberRange{"--drain-timeout-s", &Options::drain_timeout_s, 0, 3600},
    NumberRange{"--slow-ms", &Options::slow_ms, 0, 3'600'000}};

const NumberRange* RangeOfFlag(const std::string& flag) {
  const auto* const found = std::ranges::find_if(
      kRanges, [&](const NumberRange& candidate) { return candidate.flag == flag; });
  return found == kRanges.end() ? nullptr : found;
}

bool IsFraction(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

}  // namespace

void RequireRanges(const ServerOptions& options) {
  for (const NumberRange& range : kRanges) {
    const std::int64_t value = range.Of(options);
    if (value >= range.minimum && value <= range.maximum) continue;
    throw std::invalid_argument(std::string(range.flag) + ": " + std::to_string(value) +
                                " is not " + range.Text());
  }
}

std::string RangeOf(const std::string& flag) {
  const NumberRange* const range = RangeOfFlag(flag);
  if (range == nullptr) return {};
  return std::to_string(range->minimum) + " to " + std::to_string(range->maximum);
}

std::string WhyNoNumber(const std::string& flag, const std::string& text) {
  if (flag == "--trace-share" && !IsFraction(text)) return "is not a number between 0 and 1";
  const NumberRange* const range = RangeOfFlag(flag);
  if (range == nullptr) return {};
  char* end = nullptr;
  errno = 0;
  const std::int64_t value = std::strtoll(text.c_str(), &end, 0);
  const bool is_number = !text.empty() && *end == '\0' && errno == 0 && range->CanHold(value);
  return is_number ? "" : "is not a whole number " + range->Text();
}

}  // namespace fovea::server
