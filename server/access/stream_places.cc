#include "server/access/stream_places.h"

#include <chrono>

#include "server/scheduling/scheduler.h"

namespace fovea::server {

StreamPlaces::Place StreamPlaces::Take(const std::string& robot) {
  constexpr std::chrono::seconds kRetryAfter{1};
  const std::lock_guard lock(mutex_);
  if (num_streams_ >= max_streams_) {
    throw Overloaded("STREAM_LIMIT", "all " + std::to_string(max_streams_) + " streams are open",
                     kRetryAfter);
  }
  const auto of_robot = by_robot_.find(robot);
  if (of_robot != by_robot_.end() && of_robot->second >= max_per_robot_) {
    throw Overloaded("ROBOT_STREAM_LIMIT",
                     "this robot has " + std::to_string(max_per_robot_) +
                         " streams open, the most that one may have",
                     kRetryAfter);
  }
  ++num_streams_;
  ++by_robot_[robot];
  return {this, [robot](StreamPlaces* places) { places->GiveBack(robot); }};
}

void StreamPlaces::GiveBack(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  --num_streams_;
  if (--by_robot_.at(robot) == 0) by_robot_.erase(robot);
}

}  // namespace fovea::server
