#include "client/capture/stop_signal.h"

#include <signal.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace fovea::capture {
namespace {

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void AskForStop(int) { stop_asked = true; }

}  // namespace

void CatchStopSignals() {
  struct sigaction action {};
  action.sa_handler = AskForStop;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGPIPE, &action, nullptr);  // whoever read what is printed has gone
  // A terminal that closes leaves what is being written complete; with nohup it ends nothing.
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  signal(SIGXFSZ, SIG_IGN);
}

bool StopAsked() { return stop_asked; }

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
