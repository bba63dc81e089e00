#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace fovea::server {

// Bounds the memory of frames that wait in streams, of all streams: beyond its quota gRPC gives up
// calls, whosever they are. Thread-safe.
class FrameRoom {
 public:
  explicit FrameRoom(std::size_t bytes) : bytes_(bytes), left_(bytes) {}

  // For a frame of this group (RobotId), held as long as it waits. Null where it is more than a
  // quarter of what is left, so that small frames find room where large ones have taken most; one
  // that is alone always does. A quarter of all is left to groups of which no frame waits, so that
  // nobody fills it with many.
  using Place = std::shared_ptr<void>;
  Place Take(const std::string& group, std::size_t bytes);

 private:
  void GiveBack(const std::string& group, std::size_t bytes);

  const std::size_t bytes_;
  std::mutex mutex_;
  std::size_t left_;
  std::map<std::string, int> waiting_;  // frames of each group
};

}  // namespace fovea::server
