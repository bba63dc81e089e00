#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "fovea/v1/observation_service.pb.h"
#include "server/access/observer_table.h"

namespace fovea::server {

// Parts of a frame that somebody wants, as bits.
using WatchParts = unsigned;
constexpr WatchParts Bit(v1::WatchPart part) { return 1U << static_cast<unsigned>(part); }

// What a watcher asked for, checked and within its rights.
struct Wish {
  ObserverEntry observer;
  std::vector<std::string> robots;               // patterns; empty = all that the observer may see
  std::chrono::steady_clock::duration period{};  // between frames of one robot
  WatchParts parts = 0;
  bool only_problems = false;

  bool Covers(const std::string& robot) const;
};

// Throws std::invalid_argument that names the field, PermissionDenied for a part that the observer
// may not have.
Wish WishOf(const v1::WatchRequest& request, const ObserverEntry& observer);

}  // namespace fovea::server
