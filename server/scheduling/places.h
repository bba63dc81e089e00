// Who holds how many of the places for frames, and who has to make room for whom.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "server/scheduling/robot_id.h"

namespace fovea::server {

// What one robot has.
struct Holding {
  int uploading = 0;              // frames that were let in and are on their way
  int waiting = 0, computed = 0;  // frames of calls: these take places
  int threads = 0;                // that compute frames of it, streams included
  int turns = 0;                  // frames of streams that wait for one

  int places() const { return waiting + computed; }
  bool operator==(const Holding&) const = default;
};

// Not thread-safe. Costs time in proportion to those who hold something.
class Places {
 public:
  // Adds to one number of what the robot has: Change(robot, &Holding::waiting, -1).
  void Change(const RobotId& robot, int Holding::*what, int by);

  Holding Of(const RobotId& robot) const;
  Holding Of(const std::string& group) const;
  int num_taken() const { return num_taken_; }

  // How many waiting frames of others would one after the other make room for frames of `robot`:
  // those of groups that hold at least two places more than its group does, and of robots of its
  // own group that hold at least two more than itself. So nobody loses a place to one who has as
  // many.
  int NumDisplaceable(const RobotId& robot) const;
  // Who does so first: of the group that holds most the robot that does.
  std::optional<RobotId> FirstDisplaced(const RobotId& robot) const;

 private:
  using Group = std::map<std::string, Holding>;  // by name

  static Holding Sum(const Group& group);
  static std::optional<std::string> Largest(const Group& group, int least_places);

  std::map<std::string, Group> groups_;
  int num_taken_ = 0;
};

}  // namespace fovea::server
