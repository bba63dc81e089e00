#pragma once

#include <chrono>
#include <string>

namespace fovea::server {

// Whether there are others: those who were seen last, of whom two are enough to know. Not
// thread-safe.
class Company {
 public:
  using Clock = std::chrono::steady_clock;
  // Who was not seen for so long is gone.
  static constexpr std::chrono::minutes kMemory{1};

  void OnSeen(const std::string& who, Clock::time_point now) {
    if (who != last_.who) before_ = last_;
    last_ = {who, now};
  }

  // Others than `who`.
  bool HasOthers(const std::string& who, Clock::time_point now) const {
    const Seen& other = last_.who == who ? before_ : last_;
    return !other.who.empty() && now - other.at < kMemory;
  }

 private:
  struct Seen {
    std::string who;  // empty = nobody
    Clock::time_point at;
  };

  Seen last_, before_;  // of two different ones
};

}  // namespace fovea::server
