// Compute threads behind a bounded queue that is fair between robots.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/scheduling/fair_queue.h"
#include "server/scheduling/waiting_line.h"

namespace fovea::server {

// Thrown where there is too much of something already.
class Overloaded : public std::runtime_error {
 public:
  Overloaded(const char* what_is_full, const std::string& text, std::chrono::milliseconds wait)
      : std::runtime_error(text), reason(what_is_full), retry_after(wait) {}

  // Which limit it is, by which such refusals are counted: a string literal.
  const char* const reason;
  // When there should be room, going by what recent work took.
  const std::chrono::milliseconds retry_after;
};

struct SchedulerLimits {
  int num_threads = 1;    // what is computed at once
  int max_waiting = 2;    // what waits beyond that; streams are not counted
  int max_per_robot = 2;  // what one robot may have waiting or computed
  // How much the threads give way to all others: they take what time they get for a hundred
  // milliseconds, while a refusal is worth something at once only.
  int nice = 0;
};

class Scheduler {
 public:
  using Ticket = std::uint64_t;

  // Neither may throw; both run on a compute thread, `deliver` once the place in the queue is free
  // again: who is answered may at once ask for the next.
  struct Work {
    std::function<void()> compute;
    std::function<void()> deliver;
  };

  explicit Scheduler(const SchedulerLimits& limits);
  // Waits for the work that has begun; what still waits never begins.
  ~Scheduler();

  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  // Throws Overloaded where Submit() would now: where the limits forbid, and where the room left is
  // for robots that were turned away before this one; never while a thread has nothing to do.
  void RequireRoom(const std::string& robot);

  // Has `work` done when it is the robot's turn, or throws as RequireRoom() does.
  Ticket Submit(const std::string& robot, Work work);

  // The same without limits, for those who have only one piece of work waiting at any time.
  Ticket SubmitTurn(const std::string& robot, Work work);

  // Takes work back. False where it has begun or is done.
  bool Withdraw(const std::string& robot, Ticket ticket);

  // What waits now, streams included.
  std::size_t NumWaiting() const;
  // Threads that compute now.
  std::size_t NumBusy() const;

 private:
  struct Job {
    Ticket ticket = 0;
    std::string robot;
    Work work;
    bool counted = false;  // against the limits
  };

  static constexpr std::size_t kMaxTurnedAway = 1000;  // bounds what robots cost that never return

  void FindRoom(const std::string& robot);
  std::chrono::milliseconds RetryAfter(std::size_t ahead) const;
  Ticket Enqueue(const std::string& robot, Work work, bool counted);
  void Uncount(const std::string& robot);
  void RunThread();

  const SchedulerLimits limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  FairQueue<Job> queue_;
  std::map<std::string, int> counted_by_robot_;  // waiting or computed
  int num_counted_ = 0;
  WaitingLine turned_away_{kMaxTurnedAway};
  std::size_t num_waiting_ = 0;
  std::size_t num_busy_ = 0;
  Ticket last_ticket_ = 0;
  double mean_work_ms_ = 100;  // a guess until there is something to go by
  bool stopping_ = false;
  std::vector<std::jthread> threads_;  // last: the threads use all of the above
};

}  // namespace fovea::server
