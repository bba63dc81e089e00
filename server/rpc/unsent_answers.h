#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace fovea::server {

// Bounds the memory of answers that their callers have not taken yet, of all calls. Thread-safe.
class UnsentAnswers {
 public:
  explicit UnsentAnswers(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  // Held until the answer is sent, or is not. Where it does not fit with the others, those that
  // wait for longest are cancelled: who takes answers has taken them long before.
  using Token = std::shared_ptr<void>;
  Token Add(std::size_t bytes, std::function<void()> cancel);

 private:
  struct Answer {
    std::size_t bytes;
    std::function<void()> cancel;
  };

  void Remove(std::uint64_t number);

  const std::size_t max_bytes_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
  std::size_t total_bytes_ = 0;
  std::map<std::uint64_t, Answer> answers_;  // the oldest first, without those that were cancelled
};

}  // namespace fovea::server
