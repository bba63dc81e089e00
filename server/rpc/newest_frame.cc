#include "server/rpc/newest_frame.h"

#include <utility>

#include "server/rpc/option_bytes.h"

namespace fovea::server {

bool NewestFrame::Put(const std::string& group, grpc::ByteBuffer* bytes) {
  const bool drops = waits();
  if (drops) {
    LetGo();
    frame_.reset();  // and its room, before the next one takes some
    ++num_dropped_;
  }
  frame_.emplace();
  frame_->room = room_.Take(group, bytes->Length());
  frame_->sequence = num_received_++;
  frame_->at = std::chrono::steady_clock::now();
  frame_->bytes.Swap(bytes);
  bytes->Clear();
  if (!frame_->room) LetGo();
  return drops;
}

// Its options hold all the same.
void NewestFrame::LetGo() {
  if (auto options = OptionBytesOf(frame_->bytes)) options_ = std::move(options);
  frame_->bytes.Clear();
}

ReceivedFrame NewestFrame::Take() {
  ReceivedFrame frame = std::move(*frame_);
  frame_.reset();
  frame.options = std::exchange(options_, std::nullopt);
  frame.num_dropped = std::exchange(num_dropped_, 0);
  return frame;
}

}  // namespace fovea::server
