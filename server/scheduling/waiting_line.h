// The robots that were turned away, so that those who come back are served in the order in which
// they first came.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>

#include "server/scheduling/robot_id.h"

namespace fovea::server {

// A robot has one place, which it loses when it does not come back in time. Groups take turns in
// the line, too: of any other group, no more are ahead of a robot than of its own, itself included.
// Not thread-safe. Calls cost time in proportion to the robots in line, of which there are at most
// `max_places`.
class WaitingLine {
 public:
  using Clock = std::chrono::steady_clock;

  explicit WaitingLine(std::size_t max_places) : max_places_(max_places) {}

  // How many are in line before the robot; where it has no place, as if it had the last.
  std::size_t Ahead(const RobotId& robot, Clock::time_point now);

  // The robot will be back before `until`. Its place is the last, unless it has one already. Where
  // the line is full, the last of the group with the most places makes room for one of a group with
  // fewer.
  void Keep(const RobotId& robot, Clock::time_point until);
  // The same for one that has a place; else nothing.
  void Prolong(const RobotId& robot, Clock::time_point until);

  void Leave(const RobotId& robot);

 private:
  struct Place {
    RobotId robot;
    Clock::time_point until;
  };

  bool MakeRoom(const std::string& group);

  std::size_t max_places_;
  std::deque<Place> places_;  // first come first
};

}  // namespace fovea::server
