#include "server/observing/mailbox.h"

#include <algorithm>
#include <array>
#include <utility>

#include "fovea/v1/observation_service.pb.h"

namespace fovea::server {
namespace {

// Messages one after the other are one message with the fields of both.
grpc::ByteBuffer WithDropped(const grpc::Slice& message, std::uint64_t dropped) {
  v1::WatchResponse rest;
  rest.set_dropped(dropped);
  const std::array<grpc::Slice, 2> slices{message, grpc::Slice(rest.SerializeAsString())};
  return {slices.data(), dropped > 0 ? slices.size() : 1};
}

}  // namespace

Mailbox::~Mailbox() { total_ -= bytes_; }

bool Mailbox::Put(const std::string& robot, std::uint64_t sequence, const grpc::Slice& message) {
  const std::lock_guard lock(mutex_);
  auto found = letters_.find(robot);
  const std::size_t freed = found == letters_.end() ? 0 : found->second.message.size();
  const std::size_t bytes = bytes_ - freed + message.size();
  // An empty one takes anything, as otherwise a large frame would never come.
  if (bytes > max_bytes_ && letters_.size() > (freed > 0 ? 1 : 0)) return false;
  if (total_ - freed + message.size() > max_total_ && !letters_.empty()) return false;
  if (found == letters_.end()) {
    found = letters_.try_emplace(robot).first;
    order_.push_back(robot);
  }
  found->second = {.sequence = sequence, .message = message};
  total_ += message.size();
  total_ -= freed;
  bytes_ = bytes;
  return true;
}

std::optional<grpc::ByteBuffer> Mailbox::Take() {
  const std::lock_guard lock(mutex_);
  if (order_.empty()) return std::nullopt;
  const auto letter = letters_.find(order_.front());
  const std::uint64_t sequence = letter->second.sequence;
  const auto [taken, is_first] = taken_.try_emplace(letter->first, sequence - 1);
  // One that was forgotten and is back begins anew.
  const std::uint64_t dropped = sequence > taken->second ? sequence - taken->second - 1 : 0;
  taken->second = sequence;
  grpc::ByteBuffer bytes = WithDropped(letter->second.message, dropped);
  order_.pop_front();
  Remove(letter);
  return bytes;
}

void Mailbox::Forget(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  taken_.erase(robot);
  const auto letter = letters_.find(robot);
  if (letter == letters_.end()) return;
  order_.erase(std::ranges::find(order_, robot));
  Remove(letter);
}

void Mailbox::Remove(std::map<std::string, Letter>::iterator letter) {
  total_ -= letter->second.message.size();
  bytes_ -= letter->second.message.size();
  letters_.erase(letter);
}

}  // namespace fovea::server
