#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::server {

// Thrown where a robot takes no picks.
class NoPicksTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Brings what people mark to the streams of robots that take that. Of each robot one pick waits,
// the newest. Thread-safe.
class PickBoard {
 public:
  struct Outcome {
    bool delivered = false;
    std::string reason = {};  // why not
  };

  // A pick that a stream has taken; told by OnSent() that it was sent, else its stream has ended.
  class Taken;
  using TakenPtr = std::unique_ptr<Taken>;

  // The robot takes picks as long as this is held.
  using Listening = std::shared_ptr<void>;
  Listening Listen(const std::string& robot);

  // The one that waits for the robot; null where there is none.
  TakenPtr Take(const std::string& robot);

  // Returns once it is known what became of the pick. What is still waiting after `patience`, or
  // when `is_gone` says so, is taken back. Throws NoPicksTaken, also where the robot is none that
  // this person may see, and Overloaded where too many wait.
  Outcome Deliver(const std::string& robot, bool may_see, v1::Pick pick,
                  std::chrono::milliseconds patience, const std::function<bool()>& is_gone);

 private:
  enum class State { kWaiting, kTaken, kSent, kNotSent, kReplaced, kNobody };
  struct Pending {
    v1::Pick pick;
    State state = State::kWaiting;
  };
  struct Robot {
    int num_streams = 0;
    std::shared_ptr<Pending> pending;  // waits
  };

  void Settle(Pending& pending, State state);
  static Outcome OutcomeOf(State state);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Robot> robots_;  // that take picks
  std::size_t num_waiting_ = 0;
};

class PickBoard::Taken {
 public:
  Taken(PickBoard& board, std::shared_ptr<Pending> pending)
      : board_(board), pending_(std::move(pending)) {}
  ~Taken();  // not sent, unless it was

  const v1::Pick& pick() const { return pending_->pick; }
  void OnSent();

 private:
  PickBoard& board_;
  const std::shared_ptr<Pending> pending_;
  bool settled_ = false;
};

}  // namespace fovea::server
