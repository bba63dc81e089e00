#include "server/access/access_watch.h"

#include <spdlog/spdlog.h>

#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

namespace fovea::server {

AccessWatch::AccessWatch(std::chrono::seconds period, Credentials& credentials,
                         GateKeeper& gate_keeper, std::function<void()> check_calls)
    : period_(period),
      credentials_(credentials),
      gate_keeper_(gate_keeper),
      check_calls_(std::move(check_calls)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

void AccessWatch::Run(const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kCheck{1};
  constexpr std::chrono::hours kRemind{24};
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  Clock::time_point reloaded = Clock::now(), reminded = reloaded;
  credentials_.WarnOfWhatIsDue();
  while (!never.wait_for(lock, stop, kCheck, [&] { return stop.stop_requested(); })) {
    const Clock::time_point now = Clock::now();
    if (!fault_.empty() || now - reloaded >= period_) {
      Reload();
      reloaded = now;
    }
    if (now - reminded >= kRemind) {
      credentials_.WarnOfWhatIsDue();
      reminded = now;
    }
    check_calls_();
  }
}

// Says a fault once, however long it lasts.
void AccessWatch::Reload() {
  try {
    if (credentials_.Reload()) {
      gate_keeper_.SetAuthority(credentials_.authority());
      credentials_.WarnOfWhatIsDue();
    } else if (!fault_.empty()) {
      spdlog::info("the certificates fit together again");
    }
    fault_.clear();
  } catch (const std::exception& error) {
    if (fault_ != error.what()) {
      spdlog::warn("the certificates stay as they were: {}", error.what());
    }
    fault_ = error.what();
  }
}

}  // namespace fovea::server
