// The robots that were turned away, so that those who come back are served in the order in which
// they first came.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <string>

namespace fovea::server {

// A robot has one place, which it loses when it does not come back in time. Not thread-safe. Calls
// cost time in proportion to the robots in line, of which there are at most `max_places`.
class WaitingLine {
 public:
  using Clock = std::chrono::steady_clock;

  explicit WaitingLine(std::size_t max_places) : max_places_(max_places) {}

  // How many are in line before the robot; all, where it has no place.
  std::size_t Ahead(const std::string& robot, Clock::time_point now);

  // The robot will be back before `until`. Its place is the last, unless it has one already; none
  // where the line is full.
  void Keep(const std::string& robot, Clock::time_point until);

  void Leave(const std::string& robot);

 private:
  struct Place {
    std::string robot;
    Clock::time_point until;
  };

  std::size_t max_places_;
  std::deque<Place> places_;  // first come first
};

}  // namespace fovea::server
