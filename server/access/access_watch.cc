#include "server/access/access_watch.h"

#include <spdlog/spdlog.h>

#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "server/log_exception.h"

namespace fovea::server {

AccessWatch::AccessWatch(std::chrono::seconds period, Credentials& credentials,
                         GateKeeper& gate_keeper, const ObserverGate& observer_gate,
                         std::function<void()> check_calls)
    : period_(period),
      credentials_(credentials),
      gate_keeper_(gate_keeper),
      observer_gate_(observer_gate),
      check_calls_(std::move(check_calls)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

void AccessWatch::Run(const std::stop_token& stop) {
  constexpr std::chrono::seconds kCheck{1};
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  reloaded_ = std::chrono::steady_clock::now();
  CallOrLog("cannot see what has expired", [&] { Remind(); });
  while (!never.wait_for(lock, stop, kCheck, [&] { return stop.stop_requested(); })) {
    try {
      Look();
    } catch (...) {
      LogCurrentException("cannot see whether those who call may still do so");
    }
  }
}

void AccessWatch::Look() {
  const auto now = std::chrono::steady_clock::now();
  if (!fault_.empty() || now - reloaded_ >= period_) {
    Reload();
    reloaded_ = now;
  }
  check_calls_();
  constexpr std::chrono::hours kRemind{24};
  if (!reminded_ || now - *reminded_ >= kRemind) Remind();
}

void AccessWatch::Remind() {
  credentials_.WarnOfWhatIsDue();
  gate_keeper_.LogTokens(/*also_good=*/false);
  observer_gate_.LogTokens(/*also_good=*/false);
  reminded_ = std::chrono::steady_clock::now();
}

// Says a fault once, however long it lasts.
void AccessWatch::Reload() {
  try {
    if (credentials_.Reload(gate_keeper_)) {
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
