#include "server/rpc/live_calls.h"

#include <utility>
#include <vector>

namespace fovea::server {

LiveCalls::Token LiveCalls::Enter() {
  const std::lock_guard lock(mutex_);
  ++num_calls_;
  return {this, [](LiveCalls* calls) {
            const std::lock_guard inner(calls->mutex_);
            if (--calls->num_calls_ == 0) calls->none_.notify_all();
          }};
}

LiveCalls::Token LiveCalls::EnterStream(std::function<void()> end) {
  const std::lock_guard lock(mutex_);
  if (streams_end_) return nullptr;
  const int id = next_stream_++;
  streams_.emplace(id, std::move(end));
  return {this, [id](LiveCalls* calls) {
            const std::lock_guard inner(calls->mutex_);
            calls->streams_.erase(id);
          }};
}

void LiveCalls::EndStreams() {
  std::vector<std::function<void()>> ends;
  {
    const std::lock_guard lock(mutex_);
    streams_end_ = true;
    for (const auto& [id, end] : streams_) ends.push_back(end);
  }
  for (const auto& end : ends) end();
}

void LiveCalls::WaitUntilNone() {
  std::unique_lock lock(mutex_);
  none_.wait(lock, [this] { return num_calls_ == 0; });
}

}  // namespace fovea::server
