#include "client/name_lookup.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace fovea::client {

struct NameLookup::State {
  explicit State(std::vector<ServerAddress> given) : addresses(std::move(given)) {}

  const std::vector<ServerAddress> addresses;
  std::mutex mutex;
  std::condition_variable changed;
  bool running = false;
  Clock::time_point last{};
  FoundTargets found;
};

namespace {

constexpr std::chrono::seconds kFresh{5};

// In a thread that nobody waits for: the resolver cannot be interrupted.
template <typename State>
void Start(const std::shared_ptr<State>& state) {
  state->running = true;
  std::thread([state] {
    FoundTargets found = FindTargets(state->addresses);
    const std::lock_guard lock(state->mutex);
    state->running = false;
    state->last = NameLookup::Clock::now();
    // What was known is better than nothing.
    if (!found.targets.empty() || state->found.targets.empty()) state->found = std::move(found);
    state->changed.notify_all();
  }).detach();
}

}  // namespace

NameLookup::NameLookup(std::vector<ServerAddress> addresses)
    : state_(std::make_shared<State>(std::move(addresses))) {
  const std::lock_guard lock(state_->mutex);
  if (HaveNames(state_->addresses)) {
    Start(state_);
  } else {
    state_->found = FindTargets(state_->addresses);
  }
}

void NameLookup::Refresh() {
  const std::lock_guard lock(state_->mutex);
  if (!HaveNames(state_->addresses) || state_->running) return;
  if (Clock::now() - state_->last >= kFresh) Start(state_);
}

FoundTargets NameLookup::Get(Clock::time_point deadline) {
  std::unique_lock lock(state_->mutex);
  if (!state_->found.targets.empty()) return state_->found;
  if (!state_->running) Start(state_);
  if (!state_->changed.wait_until(lock, deadline, [this] { return !state_->running; })) {
    return {.targets = {}, .problem = "the server's name could not be looked up in time"};
  }
  return state_->found;
}

}  // namespace fovea::client
