// Compute threads behind a bounded queue that is fair between robots.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/scheduling/company.h"
#include "server/scheduling/places.h"
#include "server/scheduling/robot_id.h"
#include "server/scheduling/turn_queue.h"
#include "server/scheduling/waiting_line.h"

namespace fovea::server {

// Thrown where there is too much of something already.
class Overloaded : public std::runtime_error {
 public:
  Overloaded(const char* what_is_full, const std::string& text, std::chrono::milliseconds wait)
      : std::runtime_error(text), reason(what_is_full), retry_after(wait) {}

  // Which limit it is, by which such refusals are counted: a string literal.
  const char* reason;
  // When there should be room, going by what recent work took.
  std::chrono::milliseconds retry_after;
};

struct SchedulerLimits {
  int num_threads = 1;    // what is computed at once
  int max_waiting = 2;    // what waits beyond that; streams are not counted
  int max_per_robot = 2;  // what one robot may have on the way, waiting or computed
  // What one robot may have computed at once; 0: all threads may work for it, but one less while
  // others call.
  int max_running_per_robot = 0;
  // How much the threads give way to all others: they take what time they get for a hundred
  // milliseconds, while a refusal is worth something at once only.
  int nice = 0;
  // How much later than it was told a robot that was turned away may come back without losing its
  // place in line: it has to send its frame once more.
  std::chrono::milliseconds grace{500};
};

// Frames of calls take places, of which there are as many as threads and waiting ones together.
// When all are taken, a newcomer takes the place of a frame that waits, the newest one of whoever
// holds most, unless it holds as many itself (Places). Where nobody holds more it is refused, and
// served in the order of refusals when it comes back (WaitingLine).
class Scheduler {
 public:
  using Ticket = std::uint64_t;
  // A frame on its way is its robot's as long as this is held.
  using Upload = std::shared_ptr<void>;

  // The first two run on a compute thread, `deliver` once the place is free again: who is answered
  // may at once ask for the next. Instead of both, `displaced` is called where another robot took
  // the place, by the thread that submitted for that.
  struct Work {
    std::function<void()> compute;
    std::function<void()> deliver;
    std::function<void(const Overloaded&)> displaced;
  };

  // What becomes of a robot that is turned away.
  enum class IfFull {
    kKeepPlace,  // it is to come back when it is told to
    kForget,     // it asks several servers, and comes to one of them
  };

  explicit Scheduler(const SchedulerLimits& limits);
  // Waits for the work that has begun; what still waits never begins.
  ~Scheduler();

  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  // Lets a frame be uploaded. Throws Overloaded where Submit() would now: where the limits forbid,
  // and where the room left is for robots that were turned away before this one; never while a
  // thread has nothing to do. `this` must outlive what is returned.
  Upload Enter(const RobotId& robot, IfFull if_full = IfFull::kKeepPlace);

  // Has `work` done when it is the robot's turn, or throws as Enter() does, or for want of memory;
  // then it is never done. What this displaces is told so before it returns.
  Ticket Submit(const RobotId& robot, Work work);

  // The same without limits, for those who have only one piece of work waiting at any time.
  Ticket SubmitTurn(const RobotId& robot, Work work);

  // Takes work back. False where it has begun, is done or was displaced.
  bool Withdraw(const RobotId& robot, Ticket ticket);

  // What waits now, streams included.
  std::size_t NumWaiting() const;
  // Threads that compute now.
  std::size_t NumBusy() const;

 private:
  struct Job {
    Ticket ticket = 0;
    RobotId robot;
    Work work;
    bool counted = false;  // takes a place
  };

  static constexpr std::size_t kMaxTurnedAway = 1000;  // bounds what robots cost that never return

  void Stop();
  void OnSeen(const RobotId& robot);
  void FindRoom(const RobotId& robot, IfFull if_full = IfFull::kKeepPlace);
  std::optional<RobotId> WhoMakesRoom(const RobotId& robot) const;
  std::optional<Job> Displace(const RobotId& robot);
  std::chrono::milliseconds RetryAfter(std::size_t ahead) const;
  Ticket Enqueue(const RobotId& robot, Work work, bool counted);
  bool MayRun(const RobotId& robot) const;
  std::optional<Job> TakeNext();
  void RunThread();
  void Compute(Job& job);

  const SchedulerLimits limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  TurnQueue<Job> queue_;
  Places places_;
  WaitingLine turned_away_{kMaxTurnedAway};
  Company groups_seen_, robots_seen_;
  std::size_t num_waiting_ = 0;
  std::size_t num_busy_ = 0;
  Ticket last_ticket_ = 0;
  double mean_work_ms_ = 100;  // a guess until there is something to go by
  bool stopping_ = false;
  std::vector<std::jthread> threads_;  // last: the threads use all of the above
};

}  // namespace fovea::server
