#include "server/observing/pick_board.h"

#include <utility>

#include "server/scheduling/scheduler.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxWaiting = 16;  // people who wait for an outcome hold a thread each
constexpr std::chrono::milliseconds kLook{100};

}  // namespace

PickBoard::Taken::~Taken() {
  if (!settled_) board_.Settle(*pending_, State::kNotSent);
}

void PickBoard::Taken::OnSent() {
  settled_ = true;
  board_.Settle(*pending_, State::kSent);
}

void PickBoard::Settle(Pending& pending, State state) {
  const std::lock_guard lock(mutex_);
  pending.state = state;
  changed_.notify_all();
}

PickBoard::Listening PickBoard::Listen(const std::string& robot) {
  auto end = [robot = robot](PickBoard* board) {
    const std::lock_guard lock(board->mutex_);
    const auto found = board->robots_.find(robot);
    if (--found->second.num_streams > 0) return;
    if (found->second.pending) found->second.pending->state = State::kNobody;
    board->robots_.erase(found);
    board->changed_.notify_all();
  };
  {
    const std::lock_guard lock(mutex_);
    ++robots_[robot].num_streams;
  }
  // Without the lock: where there is no memory for it, it ends at once.
  return {this, std::move(end)};
}

PickBoard::TakenPtr PickBoard::Take(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  const auto found = robots_.find(robot);
  if (found == robots_.end() || !found->second.pending) return nullptr;
  std::shared_ptr<Pending> pending = std::exchange(found->second.pending, nullptr);
  pending->state = State::kTaken;
  return std::make_unique<Taken>(*this, std::move(pending));
}

PickBoard::Outcome PickBoard::Deliver(const std::string& robot, bool may_see, v1::Pick pick,
                                      std::chrono::milliseconds patience,
                                      const std::function<bool()>& is_gone) {
  const auto pending = std::make_shared<Pending>(Pending{.pick = std::move(pick)});
  std::unique_lock lock(mutex_);
  const auto found = robots_.find(robot);
  if (found == robots_.end() || !may_see) {
    throw NoPicksTaken(robot +
                       " takes no picks: it has no stream that asks for them "
                       "(DetectStreamRequest.accept_picks)");
  }
  if (num_waiting_ >= kMaxWaiting) {
    throw Overloaded("PICKS", std::to_string(num_waiting_) + " picks wait for their robots",
                     std::chrono::seconds(1));
  }
  ++num_waiting_;
  if (found->second.pending) found->second.pending->state = State::kReplaced;
  found->second.pending = pending;
  changed_.notify_all();
  const auto end = std::chrono::steady_clock::now() + patience;
  const auto is_over = [&] {
    return pending->state != State::kWaiting && pending->state != State::kTaken;
  };
  // One that a stream has taken is sent, or its stream ends.
  while (!changed_.wait_for(lock, kLook, is_over)) {
    const bool late = std::chrono::steady_clock::now() >= end || is_gone();
    if (!late || pending->state != State::kWaiting) continue;
    robots_.at(robot).pending.reset();  // it would be another's, or settled, else
    break;
  }
  --num_waiting_;
  return OutcomeOf(pending->state);
}

PickBoard::Outcome PickBoard::OutcomeOf(State state) {
  switch (state) {
    case State::kSent:
      return {.delivered = true};
    case State::kReplaced:
      return {.reason = "a newer pick took its place"};
    case State::kNobody:
    case State::kNotSent:
      return {.reason = "the robot's stream has ended"};
    default:
      return {.reason = "the robot was answered nothing in time"};
  }
}

}  // namespace fovea::server
