#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/scheduling/robot_id.h"

namespace fovea::server {

struct StreamLimits {
  int max_streams = 1000;
  int max_per_host = 500;
  int max_per_robot = 16;
};

// Bounds how many streams are open, of all, of one host where names are free (RobotId::group), and
// of one robot.
class StreamPlaces {
 public:
  explicit StreamPlaces(const StreamLimits& limits) : limits_(limits) {}

  // Held as long as the stream is open. Throws Overloaded where there is no place.
  using Place = std::shared_ptr<void>;
  Place Take(const RobotId& robot);

 private:
  void GiveBack(const RobotId& robot);

  const StreamLimits limits_;
  std::mutex mutex_;
  int num_streams_ = 0;
  std::map<std::string, int> by_group_;
  std::map<RobotId, int> by_robot_;
};

}  // namespace fovea::server
