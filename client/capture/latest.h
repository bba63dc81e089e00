#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace fovea::capture {

// Hands the newest value from one thread to another; one that was not fetched is replaced.
template <typename T>
class Latest {
 public:
  // True where it took the place of one that nobody had fetched.
  bool Put(T value) {
    const std::lock_guard lock(mutex_);
    const bool replaced = value_.has_value();
    value_ = std::move(value);
    changed_.notify_one();
    return replaced;
  }

  // What was put before is still fetched.
  void Close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_one();
  }

  // Waits for the next value; none at the end.
  std::optional<T> Take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return value_ || closed_; });
    return std::exchange(value_, std::nullopt);
  }

  // Without waiting.
  std::optional<T> TryTake() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<T> value_;
  bool closed_ = false;
};

}  // namespace fovea::capture
