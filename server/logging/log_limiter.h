#pragma once

#include <spdlog/common.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace fovea::server {

// Bounds how many lines of a kind the log gets, for lines that callers can cause as often as they
// like. Thread-safe.
class LogLimiter {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr int kLines = 20;        // of a kind in a period, and
  static constexpr int kMostCallers = 80;  // whose first line is written beyond these
  static constexpr std::chrono::seconds kPeriod{10};

  // Whether a line of this kind is to be written; else it is counted. `kind` is one of few. The
  // first line of a caller is, or one that fails often would hide what others fail for. `who`: the
  // robot, or the host where there is none; empty where it is about no caller.
  bool Admit(const std::string& kind, spdlog::level::level_enum level, const std::string& who = "",
             Clock::time_point now = Clock::now());

  // Logs for each kind whose period has passed how many lines were left out.
  void Summarize(Clock::time_point now = Clock::now());

  // That of the process.
  static LogLimiter& Global();

 private:
  struct Kind {
    Clock::time_point since;
    int written = 0;
    std::set<std::string> callers;  // of the lines written
    std::uint64_t left_out = 0;
    spdlog::level::level_enum level = spdlog::level::warn;
  };

  std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

// Logs `message` where the limit of its kind allows.
void LogLimited(const std::string& kind, spdlog::level::level_enum level,
                const std::string& message, const std::string& who = "");

}  // namespace fovea::server
