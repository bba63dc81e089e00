// What waits for its turn: groups take turns, and in the turn of a group its robots do.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "server/scheduling/fair_queue.h"
#include "server/scheduling/robot_id.h"

namespace fovea::server {

// Not thread-safe. Holds nothing of groups that wait for nothing.
template <typename T>
class TurnQueue {
 public:
  bool empty() const { return turns_.empty(); }

  void Push(const RobotId& robot, T item) {
    FairQueue<T>& queue = groups_[robot.group];
    if (queue.empty()) turns_.push_back(robot.group);
    queue.Push(robot.name, std::move(item));
  }

  // Of the first robot in turn that `may` says yes to; nothing where there is none.
  template <typename Predicate>
  std::optional<T> Pop(Predicate may) {
    for (auto turn = turns_.begin(); turn != turns_.end(); ++turn) {
      const std::string group = *turn;
      std::optional<T> item = groups_.at(group).Pop([&](const std::string& name) {
        return may(RobotId{group, name});
      });
      if (!item) continue;
      turns_.erase(turn);
      turns_.push_back(group);
      ForgetIfEmpty(group);
      return item;
    }
    return std::nullopt;
  }

  // Takes out the first, or the last, item of `robot` that `is_wanted` says yes to.
  template <typename Predicate>
  std::optional<T> Remove(const RobotId& robot, Predicate is_wanted) {
    return Take(robot.group, [&](auto& queue) { return queue.Remove(robot.name, is_wanted); });
  }
  template <typename Predicate>
  std::optional<T> RemoveLast(const RobotId& robot, Predicate is_wanted) {
    return Take(robot.group, [&](auto& queue) { return queue.RemoveLast(robot.name, is_wanted); });
  }

 private:
  template <typename Remove>
  std::optional<T> Take(const std::string& group, Remove remove) {
    const auto queue = groups_.find(group);
    if (queue == groups_.end()) return std::nullopt;
    std::optional<T> item = remove(queue->second);
    ForgetIfEmpty(group);
    return item;
  }

  void ForgetIfEmpty(const std::string& group) {
    if (!groups_.at(group).empty()) return;
    groups_.erase(group);
    turns_.erase(std::find(turns_.begin(), turns_.end(), group));
  }

  std::map<std::string, FairQueue<T>> groups_;
  std::deque<std::string> turns_;  // the keys of `groups_`, next first
};

}  // namespace fovea::server
