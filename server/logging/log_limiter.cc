#include "server/logging/log_limiter.h"

#include <spdlog/spdlog.h>

#include <vector>

#include "flags/one_line.h"
#include "server/logging/log_record.h"

namespace fovea::server {
namespace {

void LogLeftOut(const std::string& kind, std::uint64_t count, spdlog::level::level_enum level) {
  LogRecord("left_out",
            fmt::format("{} more like this in {} s:", count, LogLimiter::kPeriod.count()))
      .Text("kind", kind)
      .Number("count", static_cast<double>(count))
      .Log(level);
}

}  // namespace

bool LogLimiter::Admit(const std::string& kind, spdlog::level::level_enum level,
                       const std::string& who, Clock::time_point now) {
  Summarize(now);
  const std::lock_guard lock(mutex_);
  const auto [found, is_new] = kinds_.try_emplace(kind);
  Kind& of_kind = found->second;
  if (is_new) of_kind.since = now;
  of_kind.level = level;
  const bool is_first = !who.empty() && !of_kind.callers.contains(who);
  if (of_kind.written < kLines + (is_first ? kMostCallers : 0)) {
    ++of_kind.written;
    if (is_first) of_kind.callers.insert(who);
    return true;
  }
  ++of_kind.left_out;
  return false;
}

void LogLimiter::Summarize(Clock::time_point now) {
  std::vector<std::pair<std::string, Kind>> over;
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(kinds_, [&](const auto& kind) {
      if (now - kind.second.since < kPeriod) return false;
      if (kind.second.left_out > 0) over.push_back(kind);
      return true;
    });
  }
  for (const auto& [kind, counts] : over) LogLeftOut(kind, counts.left_out, counts.level);
}

LogLimiter& LogLimiter::Global() {
  static auto* const limiter = new LogLimiter;  // gRPC's threads may log at the very end
  return *limiter;
}

void LogLimited(const std::string& kind, spdlog::level::level_enum level,
                const std::string& message, const std::string& who) {
  if (!LogLimiter::Global().Admit(kind, level, who)) return;
  const std::size_t size = message.find_last_not_of('\n') + 1;  // what OpenCV says ends a line
  spdlog::log(level, flags::OneLine(message.substr(0, size)));
}

}  // namespace fovea::server
