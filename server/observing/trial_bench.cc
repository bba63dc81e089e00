#include "server/observing/trial_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "server/log_exception.h"
#include "server/scheduling/scheduler.h"
#include "server/scheduling/thread_priority.h"

namespace fovea::server {
namespace {

std::chrono::milliseconds WaitOf(double seconds) {
  return std::chrono::milliseconds(std::llround(1000 * std::clamp(seconds, 0.1, 10.0)));
}

}  // namespace

TrialBench::TrialBench(Limits limits)
    : limits_(limits), thread_([this](const std::stop_token& stop) { RunThread(stop); }) {}

TrialBench::~TrialBench() = default;

std::size_t TrialBench::num_done() const {
  const std::lock_guard lock(mutex_);
  return num_done_;
}

void TrialBench::Run(const std::string& person, const std::function<void()>& work) {
  Trial trial{.person = person, .work = work};
  std::unique_lock lock(mutex_);
  const auto found = by_person_.find(person);
  const std::size_t own = found == by_person_.end() ? 0 : found->second;
  if (num_held_ >= limits_.at_once || own >= limits_.of_one_person) {
    const double rounds = static_cast<double>(std::max<std::size_t>(num_held_, 1));
    const std::string whose = own >= limits_.of_one_person ? " of " + person : "";
    const std::size_t many = whose.empty() ? num_held_ : own;
    throw Overloaded("TRIALS",
                     std::to_string(many) + " frames" + whose +
                         " are tried already, the most that may be; robots come first",
                     WaitOf(rounds * mean_s_));
  }
  ++num_held_;
  ++by_person_[person];
  waiting_.push_back(&trial);
  changed_.notify_all();
  changed_.wait(lock, [&] { return trial.done; });
  --num_held_;
  if (--by_person_[person] == 0) by_person_.erase(person);
}

void TrialBench::RunThread(const std::stop_token& stop) {
  constexpr int kNicest = 19;
  LowerPriority(kNicest);
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
    Trial& trial = *waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    const auto start = std::chrono::steady_clock::now();
    try {
      trial.work();
    } catch (...) {
      LogCurrentException("a frame was not tried");
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    lock.lock();
    mean_s_ += 0.2 * (took.count() - mean_s_);
    ++num_done_;
    trial.done = true;
    changed_.notify_all();
  }
}

}  // namespace fovea::server
