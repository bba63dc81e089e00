// What waits for its turn: groups take turns, and in the turn of a group its robots do.
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "server/scheduling/fair_queue.h"
#include "server/scheduling/robot_id.h"

namespace fovea::server {

// Not thread-safe. Holds nothing of groups that wait for nothing. Without memory it is as
// FairQueue.
template <typename T>
class TurnQueue {
 public:
  bool empty() const { return turns_.empty(); }

  void Push(const RobotId& robot, T item) {
    if (const auto group = groups_.find(robot.group); group != groups_.end()) {
      group->second.Push(robot.name, std::move(item));
      return;
    }
    turns_.push_back(robot.group);
    try {
      groups_[robot.group].Push(robot.name, std::move(item));
    } catch (...) {
      groups_.erase(robot.group);
      turns_.pop_back();
      throw;
    }
  }

  // Of the first robot in turn that `may` says yes to; nothing where there is none.
  template <typename Predicate>
  std::optional<T> Pop(Predicate may) {
    for (auto turn = turns_.begin(); turn != turns_.end(); ++turn) {
      const auto group = groups_.find(*turn);
      std::optional<T> item = group->second.Pop([&](const std::string& name) {
        return may(RobotId{group->first, name});
      });
      if (!item) continue;
      if (group->second.empty()) {
        groups_.erase(group);
        turns_.erase(turn);
      } else {
        std::rotate(turn, std::next(turn), turns_.end());
      }
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
    if (queue->second.empty()) {
      groups_.erase(queue);
      turns_.erase(std::find(turns_.begin(), turns_.end(), group));
    }
    return item;
  }

  std::map<std::string, FairQueue<T>> groups_;
  std::deque<std::string> turns_;  // the keys of `groups_`, next first
};

}  // namespace fovea::server
