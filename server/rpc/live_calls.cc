#include "server/rpc/live_calls.h"

#include <utility>
#include <vector>

namespace fovea::server {

LiveCalls::Token LiveCalls::Enter() {
  {
    const std::lock_guard lock(mutex_);
    ++num_entered_;
  }
  // Without the lock: where there is no memory for it, it ends at once.
  return {this, [](LiveCalls* calls) {
            const std::lock_guard lock(calls->mutex_);
            --calls->num_entered_;
            calls->changed_.notify_all();
          }};
}

LiveCalls::Token LiveCalls::Begin(std::function<void()> on_stop, std::function<void()> on_check) {
  std::uint64_t id = 0;
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return nullptr;
    id = ++last_id_;
    begun_.emplace(id, Begun{std::move(on_stop), std::move(on_check)});
  }
  // Without the lock, as above.
  return {this, [id](LiveCalls* calls) {
            const std::lock_guard lock(calls->mutex_);
            calls->begun_.erase(id);
            calls->changed_.notify_all();
          }};
}

void LiveCalls::Stop() {
  std::vector<std::function<void()>> on_stops;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (const auto& [id, call] : begun_) on_stops.push_back(call.on_stop);
  }
  for (const auto& on_stop : on_stops) on_stop();
}

void LiveCalls::Check() {
  std::vector<std::function<void()>> on_checks;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, call] : begun_) on_checks.push_back(call.on_check);
  }
  for (const auto& on_check : on_checks) on_check();
}

std::size_t LiveCalls::GiveUp() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  return begun_.size();
}

void LiveCalls::WaitUntilIdle(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, deadline, [this] { return begun_.empty(); });
}

void LiveCalls::WaitUntilNone() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return num_entered_ == 0; });
}

}  // namespace fovea::server
