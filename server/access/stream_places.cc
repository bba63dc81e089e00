#include "server/access/stream_places.h"

#include <chrono>
#include <utility>

#include "server/scheduling/refusal_reasons.h"
#include "server/scheduling/scheduler.h"

namespace fovea::server {
namespace {

// Throws where `key` has `max` streams open.
template <typename Key>
void RequireFewer(const std::map<Key, int>& counts, const Key& key, int max, const char* reason,
                  const std::string& who) {
  const auto found = counts.find(key);
  if (found == counts.end() || found->second < max) return;
  throw Overloaded(
      reason, who + " has " + std::to_string(max) + " streams open, the most that one may have",
      std::chrono::seconds{1});
}

template <typename Key>
void CountDown(std::map<Key, int>& counts, const Key& key) {
  if (--counts.at(key) == 0) counts.erase(key);
}

}  // namespace

StreamPlaces::Place StreamPlaces::Take(const RobotId& robot) {
  auto give_back = [robot = robot](StreamPlaces* places) { places->GiveBack(robot); };
  std::unique_lock lock(mutex_);
  if (num_streams_ >= limits_.max_streams) {
    throw Overloaded(kStreamLimit,
                     "all " + std::to_string(limits_.max_streams) + " streams are open",
                     std::chrono::seconds{1});
  }
  RequireFewer(by_robot_, robot, limits_.max_per_robot, kRobotStreamLimit, "this robot");
  RequireFewer(by_group_, robot.group, limits_.max_per_host, kHostStreamLimit, "this host");
  // Both before anything is counted.
  int& of_group = by_group_[robot.group];
  int& of_robot = by_robot_[robot];
  ++num_streams_;
  ++of_group;
  ++of_robot;
  lock.unlock();  // where there is no memory for it, it is given back at once
  return {this, std::move(give_back)};
}

void StreamPlaces::GiveBack(const RobotId& robot) {
  const std::lock_guard lock(mutex_);
  --num_streams_;
  CountDown(by_group_, robot.group);
  CountDown(by_robot_, robot);
}

}  // namespace fovea::server
