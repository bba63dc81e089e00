#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace fovea::server {

// How many tokens a file holds, and whose have expired or soon will: within two weeks.
class TokenCensus {
 public:
  explicit TokenCensus(std::chrono::sys_seconds now) : now_(now) {}

  void Add(const std::string& name, std::chrono::sys_seconds expires);

  bool has_good() const { return all_ > expired_.size(); }
  bool is_due() const { return !expired_.empty() || !soon_.empty(); }

  // "12 tokens; expired: bert; within 14 days: dora, eve".
  std::string Text() const;

  // The same after "--tokens: FILE holds "; where none is due, only if `also_good`.
  void Log(const std::string& flag, const std::string& file, bool also_good) const;

 private:
  std::chrono::sys_seconds now_;
  std::size_t all_ = 0;
  std::vector<std::string> expired_, soon_;
};

}  // namespace fovea::server
