#include "server/scheduling/waiting_line.h"

#include <algorithm>
#include <map>
#include <string>

namespace fovea::server {

std::size_t WaitingLine::Ahead(const RobotId& robot, Clock::time_point now) {
  std::erase_if(places_, [&](const Place& place) { return place.until < now; });
  std::map<std::string_view, std::size_t> before;  // by group
  for (const Place& place : places_) {
    if (place.robot == robot) break;
    ++before[place.robot.group];
  }
  const std::size_t of_own_group = before[robot.group];
  std::size_t ahead = 0;
  for (const auto& [group, count] : before) {
    ahead += group == robot.group ? count : std::min(count, of_own_group + 1);
  }
  return ahead;
}

void WaitingLine::Keep(const RobotId& robot, Clock::time_point until) {
  if (std::ranges::find(places_, robot, &Place::robot) != places_.end()) {
    Prolong(robot, until);
  } else if (places_.size() < max_places_ || MakeRoom(robot.group)) {
    places_.push_back({robot, until});
  }
}

void WaitingLine::Prolong(const RobotId& robot, Clock::time_point until) {
  const auto own = std::ranges::find(places_, robot, &Place::robot);
  if (own != places_.end()) own->until = std::max(own->until, until);
}

void WaitingLine::Leave(const RobotId& robot) {
  std::erase_if(places_, [&](const Place& place) { return place.robot == robot; });
}

bool WaitingLine::MakeRoom(const std::string& group) {
  std::map<std::string_view, std::size_t> count;
  for (const Place& place : places_) ++count[place.robot.group];
  const auto most = std::ranges::max_element(count, {}, [](const auto& of) { return of.second; });
  if (most == count.end() || most->second <= count[group] + 1) return false;
  const auto last = std::find_if(places_.rbegin(), places_.rend(), [&](const Place& place) {
    return place.robot.group == most->first;
  });
  places_.erase(std::prev(last.base()));
  return true;
}

}  // namespace fovea::server
