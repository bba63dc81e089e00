#include "server/rpc/newest_frame.h"

#include <utility>

#include "server/rpc/option_bytes.h"

namespace fovea::server {

bool NewestFrame::Put(grpc::ByteBuffer* bytes) {
  const bool drops = waits();
  if (drops) {
    LetGo();
    frame_.reset();  // and its room, before the next one takes some
    ++num_dropped_;
  }
  frame_ = {.bytes = {},
            .room = room_.Take(bytes->Length()),
            .sequence = num_received_++,
            .at = std::chrono::steady_clock::now()};
  frame_->bytes.Swap(bytes);
  bytes->Clear();
  if (!frame_->room) LetGo();
  return drops;
}

void NewestFrame::LetGo() {
  if (auto options = OptionBytesOf(frame_->bytes)) options_ = std::move(options);
  frame_->bytes.Clear();
}

NewestFrame::Received NewestFrame::Take() {
  Received frame = std::move(*frame_);
  frame_.reset();
  return frame;
}

std::optional<std::string> NewestFrame::TakeOptions() {
  return std::exchange(options_, std::nullopt);
}

std::uint64_t NewestFrame::TakeNumDropped() { return std::exchange(num_dropped_, 0); }

}  // namespace fovea::server
