#include "server/scheduling/scheduler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/log_exception.h"
#include "server/scheduling/refusal_reasons.h"
#include "server/scheduling/thread_priority.h"
#include "server/until_it_works.h"

namespace fovea::server {
namespace {

using Clock = WaitingLine::Clock;

// How long the place is kept for a robot that has come back, while its frame is on the way.
constexpr std::chrono::seconds kLongestUpload{10};

// What is thrown here has nobody else to go to.
void Call(const std::function<void()>& work) noexcept { CallOrLog("work was not done", work); }

// Frames of streams wait for a turn.
int Holding::*WaitingOf(bool counted) { return counted ? &Holding::waiting : &Holding::turns; }

}  // namespace

Scheduler::Scheduler(const SchedulerLimits& limits) : limits_(limits) {
  try {
    for (int i = 0; i < limits_.num_threads; ++i) threads_.emplace_back([this] { RunThread(); });
  } catch (...) {  // those that there are would be waited for
    Stop();
    throw;
  }
}

Scheduler::~Scheduler() { Stop(); }

void Scheduler::Stop() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  changed_.notify_all();
}

Scheduler::Upload Scheduler::Enter(const RobotId& robot, IfFull if_full) {
  // Not const, so that it can be moved, which needs no memory.
  auto give_back = [robot = robot](Scheduler* scheduler) {
    const std::lock_guard lock(scheduler->mutex_);
    scheduler->places_.Change(robot, &Holding::uploading, -1);
  };
  {
    const std::lock_guard lock(mutex_);
    OnSeen(robot);
    FindRoom(robot, if_full);
    turned_away_.Prolong(robot, Clock::now() + kLongestUpload);
    places_.Change(robot, &Holding::uploading, +1);
  }
  // Without the lock: where there is no memory for it, it is given back at once.
  return {this, std::move(give_back)};
}

Scheduler::Ticket Scheduler::Submit(const RobotId& robot, Work work) {
  std::optional<Job> displaced;
  std::unique_lock lock(mutex_);
  OnSeen(robot);
  FindRoom(robot);
  const std::optional<RobotId> other = WhoMakesRoom(robot);
  const std::size_t others = static_cast<std::size_t>(limits_.max_waiting);
  const Overloaded why(kDisplaced, "a robot that holds fewer places took that of this frame",
                       RetryAfter(others));
  const Ticket ticket = Enqueue(robot, std::move(work), /*counted=*/true);
  // None of this needs memory, so that both frames have their ends.
  turned_away_.Leave(robot);
  if (other) displaced = Displace(*other);
  lock.unlock();
  if (displaced) Call([&] { displaced->work.displaced(why); });
  return ticket;
}

Scheduler::Ticket Scheduler::SubmitTurn(const RobotId& robot, Work work) {
  const std::lock_guard lock(mutex_);
  OnSeen(robot);
  return Enqueue(robot, std::move(work), /*counted=*/false);
}

bool Scheduler::Withdraw(const RobotId& robot, Ticket ticket) {
  std::optional<Job> job;  // is given back without the lock
  const std::lock_guard lock(mutex_);
  job = queue_.Remove(robot, [&](const Job& other) { return other.ticket == ticket; });
  if (!job) return false;
  --num_waiting_;
  places_.Change(robot, WaitingOf(job->counted), -1);
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

void Scheduler::OnSeen(const RobotId& robot) {
  const Clock::time_point now = Clock::now();
  groups_seen_.OnSeen(robot.group, now);
  robots_seen_.OnSeen(robot.group + '\n' + robot.name, now);
}

void Scheduler::FindRoom(const RobotId& robot, IfFull if_full) {
  const Holding own = places_.Of(robot);
  const int num_own = own.uploading + own.places();
  if (num_own >= limits_.max_per_robot) {
    throw Overloaded(kRobotLimit,
                     "this robot has " + std::to_string(num_own) +
                         " frames on the way, waiting or computed, the most that one may have "
                         "(--max-per-robot): wait for an answer before the next",
                     RetryAfter(static_cast<std::size_t>(num_own)));
  }
  const Clock::time_point now = Clock::now();
  const std::size_t ahead = turned_away_.Ahead(robot, now);
  const int num_taken = places_.num_taken();
  const int num_free =
      limits_.num_threads + limits_.max_waiting - num_taken + places_.NumDisplaceable(robot);
  const bool idle = num_taken < limits_.num_threads;
  if ((idle ? 0 : static_cast<int>(ahead)) < num_free) return;
  const std::chrono::milliseconds retry_after =
      RetryAfter(ahead + static_cast<std::size_t>(num_own));
  // Who has frames here already waits by these.
  if (num_own == 0 && if_full == IfFull::kKeepPlace)
    turned_away_.Keep(robot, now + retry_after + limits_.grace);
  std::string text = "the queue is full with " + std::to_string(num_taken) + " frames";
  if (ahead > 0) text += " and " + std::to_string(ahead) + " robots in line";
  throw Overloaded(kQueueFull, text, retry_after);
}

// Where all places are taken; then FindRoom() has seen that there is somebody.
std::optional<RobotId> Scheduler::WhoMakesRoom(const RobotId& robot) const {
  if (places_.num_taken() < limits_.num_threads + limits_.max_waiting) return std::nullopt;
  return places_.FirstDisplaced(robot);
}

std::optional<Scheduler::Job> Scheduler::Displace(const RobotId& robot) {
  std::optional<Job> job = queue_.RemoveLast(robot, [](const Job& one) { return one.counted; });
  --num_waiting_;
  places_.Change(robot, &Holding::waiting, -1);
  return job;
}

std::chrono::milliseconds Scheduler::RetryAfter(std::size_t ahead) const {
  const double rounds = static_cast<double>(ahead + 1) / limits_.num_threads;
  return std::chrono::milliseconds(
      static_cast<std::int64_t>(std::clamp(std::ceil(rounds * mean_work_ms_), 10.0, 10'000.0)));
}

Scheduler::Ticket Scheduler::Enqueue(const RobotId& robot, Work work, bool counted) {
  places_.Change(robot, WaitingOf(counted), +1);
  try {
    queue_.Push(robot, {++last_ticket_, robot, std::move(work), counted});
  } catch (...) {
    places_.Change(robot, WaitingOf(counted), -1);
    throw;
  }
  ++num_waiting_;
  changed_.notify_one();
  return last_ticket_;
}

// One thread less for one robot, or one group, than there are, where there are others, so that they
// need not wait for its frames however long these take.
bool Scheduler::MayRun(const RobotId& robot) const {
  const Clock::time_point now = Clock::now();
  const int all = limits_.num_threads, but_one = std::max(1, all - 1);
  const auto most = [&](bool has_others) { return has_others ? but_one : all; };
  const int own = limits_.max_running_per_robot > 0
                      ? limits_.max_running_per_robot
                      : most(robots_seen_.HasOthers(robot.group + '\n' + robot.name, now));
  return places_.Of(robot).threads < own &&
         places_.Of(robot.group).threads < most(groups_seen_.HasOthers(robot.group, now));
}

std::optional<Scheduler::Job> Scheduler::TakeNext() {
  std::optional<Job> job = queue_.Pop([this](const RobotId& robot) { return MayRun(robot); });
  if (!job) return std::nullopt;
  --num_waiting_;
  ++num_busy_;
  // The robot holds something throughout, so that none of this needs memory.
  places_.Change(job->robot, &Holding::threads, +1);
  places_.Change(job->robot, WaitingOf(job->counted), -1);
  if (job->counted) places_.Change(job->robot, &Holding::computed, +1);
  return job;
}

void Scheduler::RunThread() {
  LowerPriority(limits_.nice);
  while (true) {
    std::optional<Job> job;
    UntilItWorks([&] {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return stopping_ || (job = TakeNext()).has_value(); });
    });
    if (!job) return;
    Compute(*job);
  }
}

void Scheduler::Compute(Job& job) {
  const auto start = Clock::now();
  Call(job.work.compute);
  const std::chrono::duration<double, std::milli> took = Clock::now() - start;
  {
    const std::lock_guard lock(mutex_);
    mean_work_ms_ += 0.1 * (took.count() - mean_work_ms_);
    --num_busy_;
    places_.Change(job.robot, &Holding::threads, -1);
    if (job.counted) places_.Change(job.robot, &Holding::computed, -1);
    changed_.notify_one();  // its robot may have another thread now
  }
  Call(job.work.deliver);
}

}  // namespace fovea::server
