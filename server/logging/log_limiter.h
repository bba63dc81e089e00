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

  static constexpr int kLines = 20;       // of a kind in a period, and
  static constexpr int kMostRobots = 80;  // whose first line is written beyond these
  static constexpr std::chrono::seconds kPeriod{10};

  // Whether a line of this kind is to be written; else it is counted. `kind` is one of few. The
  // first line of a robot is, or one that fails often would hide what others fail for. `robot`:
  // empty where it is about none.
  bool Admit(const std::string& kind, spdlog::level::level_enum level,
             const std::string& robot = "", Clock::time_point now = Clock::now());

  // Logs for each kind whose period has passed how many lines were left out.
  void Summarize(Clock::time_point now = Clock::now());

  // That of the process.
  static LogLimiter& Global();

 private:
  struct Kind {
    Clock::time_point since;
    int written = 0;
    std::set<std::string> robots;  // of the lines written
    std::uint64_t left_out = 0;
    spdlog::level::level_enum level = spdlog::level::warn;
  };

  std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

// Logs `message` where the limit of its kind allows.
void LogLimited(const std::string& kind, spdlog::level::level_enum level,
                const std::string& message);

}  // namespace fovea::server
