#include "server/rpc/frame_room.h"

#include <algorithm>

namespace fovea::server {

FrameRoom::Place FrameRoom::Take(std::size_t bytes) {
  bytes = std::min(bytes, bytes_);
  {
    const std::lock_guard lock(mutex_);
    const bool is_alone = left_ == bytes_;
    if (bytes > left_ / 4 && !is_alone) return nullptr;
    left_ -= bytes;
  }
  return {this, [bytes](FrameRoom* room) { room->GiveBack(bytes); }};
}

void FrameRoom::GiveBack(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  left_ += bytes;
}

}  // namespace fovea::server
