#include "server/rpc/frame_room.h"

#include <algorithm>
#include <utility>

namespace fovea::server {

FrameRoom::Place FrameRoom::Take(const std::string& group, std::size_t bytes) {
  bytes = std::min(bytes, bytes_);
  auto give_back = [group = group, bytes](FrameRoom* room) { room->GiveBack(group, bytes); };
  {
    const std::lock_guard lock(mutex_);
    const std::size_t kept = waiting_.contains(group) ? bytes_ / 4 : 0;  // for the other groups
    const bool is_alone = left_ == bytes_;
    if (bytes > (left_ - std::min(left_, kept)) / 4 && !is_alone) return nullptr;
    ++waiting_[group];
    left_ -= bytes;
  }
  // Without the lock: where there is no memory for it, it is given back at once.
  return {this, std::move(give_back)};
}

void FrameRoom::GiveBack(const std::string& group, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  left_ += bytes;
  const auto waiting = waiting_.find(group);
  if (--waiting->second == 0) waiting_.erase(waiting);
}

}  // namespace fovea::server
