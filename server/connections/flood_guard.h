#pragma once

#include <chrono>
#include <cstdint>

#include "server/connections/connection_table.h"

namespace fovea::server {

// Sees to it that gRPC does not queue more calls than there is memory for: who begins calls only to
// reset them (CVE-2023-44487) has no other limit. Not thread-safe.
class FloodGuard {
 public:
  using Clock = ConnectionTable::Clock;

  explicit FloodGuard(ConnectionTable& connections);

  // Looks at what was begun since the last time, and has the table end connections that began too
  // many. What comes between two looks is not bounded.
  void Inspect(Clock::time_point now);

  // More came than can be looked at: nobody should be let in before that has passed, a second or
  // so.
  bool IsFlooded() const { return budget_ < 0; }

 private:
  ConnectionTable& connections_;
  Clock::time_point looked_;
  std::uint64_t begun_;  // by then
  double budget_;        // calls that may come now
};

}  // namespace fovea::server
