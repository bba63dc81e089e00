#include "server/scheduling/places.h"

#include <algorithm>

namespace fovea::server {
namespace {

// Of one that holds `other` if it shall keep one place more than `own_places` at least.
int NumSpare(const Holding& other, int own_places) {
  return std::min(other.waiting, std::max(0, other.places() - own_places - 1));
}

}  // namespace

void Places::Change(const RobotId& robot, int Holding::*what, int by) {
  Group& group = groups_[robot.group];
  Holding& holding = group[robot.name];
  num_taken_ -= holding.places();
  holding.*what += by;
  num_taken_ += holding.places();
  if (holding == Holding{}) group.erase(robot.name);
  if (group.empty()) groups_.erase(robot.group);
}

Holding Places::Of(const RobotId& robot) const {
  const auto group = groups_.find(robot.group);
  if (group == groups_.end()) return {};
  const auto holding = group->second.find(robot.name);
  return holding == group->second.end() ? Holding{} : holding->second;
}

Holding Places::Of(const std::string& group) const {
  const auto found = groups_.find(group);
  return found == groups_.end() ? Holding{} : Sum(found->second);
}

int Places::NumDisplaceable(const RobotId& robot) const {
  const int of_group = Of(robot.group).places(), own = Of(robot).places();
  int count = 0;
  for (const auto& [name, group] : groups_) {
    if (name != robot.group) {
      count += NumSpare(Sum(group), of_group);
      continue;
    }
    for (const auto& [other, holding] : group) {
      if (other != robot.name) count += NumSpare(holding, own);
    }
  }
  return count;
}

std::optional<RobotId> Places::FirstDisplaced(const RobotId& robot) const {
  const int of_group = Of(robot.group).places();
  std::optional<RobotId> first;
  int most = of_group + 1;
  for (const auto& [name, group] : groups_) {
    const Holding all = Sum(group);
    if (name == robot.group || all.waiting == 0 || all.places() <= most) continue;
    most = all.places();
    first = RobotId{name, *Largest(group, 0)};
  }
  if (first || !groups_.contains(robot.group)) return first;
  const auto name = Largest(groups_.at(robot.group), Of(robot).places() + 2);
  if (name) first = RobotId{robot.group, *name};
  return first;
}

Holding Places::Sum(const Group& group) {
  Holding sum;
  for (const auto& [name, holding] : group) {
    sum.uploading += holding.uploading;
    sum.waiting += holding.waiting;
    sum.computed += holding.computed;
    sum.threads += holding.threads;
    sum.turns += holding.turns;
  }
  return sum;
}

// The name with most places among those of which something waits.
std::optional<std::string> Places::Largest(const Group& group, int least_places) {
  std::optional<std::string> largest;
  int most = least_places - 1;
  for (const auto& [name, holding] : group) {
    if (holding.waiting == 0 || holding.places() <= most) continue;
    most = holding.places();
    largest = name;
  }
  return largest;
}

}  // namespace fovea::server
