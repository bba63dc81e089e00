#include "client/capture/stop_signal.h"

#include <signal.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

namespace fovea::capture {
namespace {

std::atomic<bool> stop_asked = false;
std::atomic<bool> stop_demanded = false;
std::atomic<std::int64_t> first_asked_ms = 0;  // 0 = never
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void AskForStop(int) { stop_asked = true; }

// A person who asks again does not want to wait. What comes at once is the same signal, as a shell
// and timeout(1) pass it on to who has it already.
void AskOrDemand(int) {
  constexpr std::int64_t kSameMs = 300;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t now_ms = now.tv_sec * 1000 + now.tv_nsec / 1'000'000;
  std::int64_t first_ms = 0;
  if (!first_asked_ms.compare_exchange_strong(first_ms, now_ms) && now_ms - first_ms >= kSameMs) {
    stop_demanded = true;
  }
  stop_asked = true;
}

}  // namespace

void CatchStopSignals() {
  struct sigaction action {};
  action.sa_handler = AskOrDemand;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = AskForStop;
  sigaction(SIGPIPE, &action, nullptr);  // whoever read what is printed has gone
  // A terminal that closes leaves what is being written complete; with nohup it ends nothing.
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  signal(SIGXFSZ, SIG_IGN);
}

bool StopAsked() { return stop_asked; }

bool StopDemanded() { return stop_demanded; }

bool StopAskedWithin(std::chrono::milliseconds time) {
  using std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kMoment{20};  // a handler of signals can wake nobody
  const steady_clock::time_point end = steady_clock::now() + time;
  while (!StopAsked() && steady_clock::now() < end) {
    std::this_thread::sleep_until(std::min(end, steady_clock::now() + kMoment));
  }
  return StopAsked();
}

}  // namespace fovea::capture
