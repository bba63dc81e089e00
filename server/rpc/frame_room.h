#pragma once

#include <cstddef>
#include <memory>
#include <mutex>

namespace fovea::server {

// Bounds the memory of frames that wait in streams, of all streams: beyond its quota gRPC gives up
// calls, whosever they are. Thread-safe.
class FrameRoom {
 public:
  explicit FrameRoom(std::size_t bytes) : bytes_(bytes), left_(bytes) {}

  // Held as long as the frame waits. Null where it is more than a quarter of what is left, so that
  // small frames find room where large ones have taken most; one that is alone always does.
  using Place = std::shared_ptr<void>;
  Place Take(std::size_t bytes);

 private:
  void GiveBack(std::size_t bytes);

  const std::size_t bytes_;
  std::mutex mutex_;
  std::size_t left_;
};

}  // namespace fovea::server
