#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "server/rpc/frame_room.h"

namespace fovea::server {

// A message of a stream as it came: it is parsed when its turn has come, and not at all where it is
// dropped.
struct ReceivedFrame {
  grpc::ByteBuffer bytes;
  FrameRoom::Place room;  // null: there was none for the bytes
  // Of what had no room and of frames dropped before it, the last ones that were said.
  std::optional<std::string> options;
  std::uint64_t sequence = 0, num_dropped = 0;  // the latter since the last one taken
  std::chrono::steady_clock::time_point at;
};

// What has come of a stream and is not worked on yet: the newest frame waits, what waited before it
// is dropped. Not thread-safe.
class NewestFrame {
 public:
  explicit NewestFrame(FrameRoom& room) : room_(room) {}

  std::uint64_t num_received() const { return num_received_; }
  bool waits() const { return frame_.has_value(); }

  // Takes the bytes, which are of this group (RobotId). Returns whether one was dropped for it.
  bool Put(const std::string& group, grpc::ByteBuffer* bytes);

  // Of one that waits, once.
  ReceivedFrame Take();

 private:
  void LetGo();

  FrameRoom& room_;
  std::optional<ReceivedFrame> frame_;
  std::optional<std::string> options_;
  std::uint64_t num_received_ = 0;
  std::uint64_t num_dropped_ = 0;
};

}  // namespace fovea::server
