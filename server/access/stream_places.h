#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace fovea::server {

// Bounds how many streams are open, of all and of one robot.
class StreamPlaces {
 public:
  StreamPlaces(int max_streams, int max_per_robot)
      : max_streams_(max_streams), max_per_robot_(max_per_robot) {}

  // Held as long as the stream is open. Throws Overloaded where there is no place.
  using Place = std::shared_ptr<void>;
  Place Take(const std::string& robot);

 private:
  void GiveBack(const std::string& robot);

  const int max_streams_, max_per_robot_;
  std::mutex mutex_;
  int num_streams_ = 0;
  std::map<std::string, int> by_robot_;
};

}  // namespace fovea::server
