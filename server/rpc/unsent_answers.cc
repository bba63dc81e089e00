#include "server/rpc/unsent_answers.h"

#include <spdlog/spdlog.h>

#include <utility>
#include <vector>

#include "server/logging/log_limiter.h"

namespace fovea::server {

UnsentAnswers::Token UnsentAnswers::Add(std::size_t bytes, std::function<void()> cancel) {
  std::vector<std::function<void()>> cancelled;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = next_++;
    answers_.emplace(number, Answer{bytes, std::move(cancel)});
    total_bytes_ += bytes;
    while (total_bytes_ > max_bytes_ && answers_.size() > 1) {
      const auto oldest = answers_.begin();
      total_bytes_ -= oldest->second.bytes;
      cancelled.push_back(std::move(oldest->second.cancel));
      answers_.erase(oldest);
    }
  }
  if (!cancelled.empty() && LogLimiter::Global().Admit("unsent answers", spdlog::level::warn)) {
    spdlog::warn("callers do not take their answers: more than --max-unsent-mib wait; ending {}",
                 cancelled.size());
  }
  for (const auto& end : cancelled) end();
  return {nullptr, [this, number](void*) { Remove(number); }};
}

void UnsentAnswers::Remove(std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  const auto answer = answers_.find(number);
  if (answer == answers_.end()) return;
  total_bytes_ -= answer->second.bytes;
  answers_.erase(answer);
}

}  // namespace fovea::server
