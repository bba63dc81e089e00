#include "server/scheduling/scheduler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/scheduling/thread_priority.h"

namespace fovea::server {
namespace {

// How much later than it was told a robot may come back without losing its place in line: it has
// to send its frame once more.
constexpr std::chrono::milliseconds kGrace{500};

}  // namespace

Scheduler::Scheduler(const SchedulerLimits& limits) : limits_(limits) {
  for (int i = 0; i < limits_.num_threads; ++i) threads_.emplace_back([this] { RunThread(); });
}

Scheduler::~Scheduler() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  changed_.notify_all();
}

void Scheduler::RequireRoom(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  FindRoom(robot);
}

Scheduler::Ticket Scheduler::Submit(const std::string& robot, Work work) {
  const std::lock_guard lock(mutex_);
  FindRoom(robot);
  turned_away_.Leave(robot);
  ++num_counted_;
  ++counted_by_robot_[robot];
  return Enqueue(robot, std::move(work), /*counted=*/true);
}

Scheduler::Ticket Scheduler::SubmitTurn(const std::string& robot, Work work) {
  const std::lock_guard lock(mutex_);
  return Enqueue(robot, std::move(work), /*counted=*/false);
}

bool Scheduler::Withdraw(const std::string& robot, Ticket ticket) {
  const std::lock_guard lock(mutex_);
  bool counted = false;
  const auto is_it = [&](const Job& job) {
    counted = job.counted;
    return job.ticket == ticket;
  };
  if (!queue_.Remove(robot, is_it)) return false;
  --num_waiting_;
  if (counted) Uncount(robot);
  return true;
}

std::size_t Scheduler::NumWaiting() const {
  const std::lock_guard lock(mutex_);
  return num_waiting_;
}

std::size_t Scheduler::NumBusy() const {
  const std::lock_guard lock(mutex_);
  return num_busy_;
}

void Scheduler::FindRoom(const std::string& robot) {
  const auto of_robot = counted_by_robot_.find(robot);
  if (of_robot != counted_by_robot_.end() && of_robot->second >= limits_.max_per_robot) {
    throw Overloaded("ROBOT_LIMIT",
                     "this robot has " + std::to_string(of_robot->second) +
                         " frames waiting or computed, the most that one may have",
                     RetryAfter(0));
  }
  const auto now = WaitingLine::Clock::now();
  const std::size_t ahead = turned_away_.Ahead(robot, now);
  const int taken =
      num_counted_ + (num_counted_ < limits_.num_threads ? 0 : static_cast<int>(ahead));
  if (taken < limits_.num_threads + limits_.max_waiting) return;
  const std::chrono::milliseconds retry_after = RetryAfter(ahead);
  turned_away_.Keep(robot, now + retry_after + kGrace);
  std::string text = "the queue is full with " + std::to_string(num_counted_) + " frames";
  if (ahead > 0) text += " and " + std::to_string(ahead) + " robots in line";
  throw Overloaded("QUEUE_FULL", text, retry_after);
}

std::chrono::milliseconds Scheduler::RetryAfter(std::size_t ahead) const {
  const double rounds = static_cast<double>(ahead + 1) / limits_.num_threads;
  return std::chrono::milliseconds(
      static_cast<std::int64_t>(std::clamp(std::ceil(rounds * mean_work_ms_), 10.0, 10'000.0)));
}

Scheduler::Ticket Scheduler::Enqueue(const std::string& robot, Work work, bool counted) {
  queue_.Push(robot, {++last_ticket_, robot, std::move(work), counted});
  ++num_waiting_;
  changed_.notify_one();
  return last_ticket_;
}

void Scheduler::Uncount(const std::string& robot) {
  --num_counted_;
  const auto of_robot = counted_by_robot_.find(robot);
  if (--of_robot->second == 0) counted_by_robot_.erase(of_robot);
}

void Scheduler::RunThread() {
  LowerPriority(limits_.nice);
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
    if (stopping_) return;
    Job job = queue_.Pop();
    --num_waiting_;
    ++num_busy_;
    lock.unlock();
    const auto start = std::chrono::steady_clock::now();
    job.work.compute();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    lock.lock();
    --num_busy_;
    mean_work_ms_ += 0.1 * (took.count() - mean_work_ms_);
    if (job.counted) Uncount(job.robot);
    lock.unlock();
    job.work.deliver();
    job = {};  // what it holds is given back without the lock
    lock.lock();
  }
}

}  // namespace fovea::server
