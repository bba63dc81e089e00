#include "server/observing/watch_hub.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "server/log_exception.h"
#include "server/observing/watched_message.h"
#include "server/scheduling/scheduler.h"
#include "server/scheduling/thread_priority.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxWatchers = 64, kMaxRobots = 1024;
constexpr std::size_t kMaxPending = std::size_t{16} << 20;  // frames that wait for pictures
constexpr std::size_t kMaxMail = std::size_t{16} << 20;     // messages, of one watcher
constexpr std::size_t kMaxMailOfAll = std::size_t{32} << 20;

}  // namespace

WatchHub::Watcher::Watcher(Wish w, std::function<void()> news, std::atomic<std::size_t>& total)
    : wish(std::move(w)), on_news(std::move(news)), mailbox(kMaxMail, kMaxMailOfAll, total) {}

WatchHub::WatchHub(std::uint64_t max_pixels)
    : max_pixels_(max_pixels), thread_([this](const std::stop_token& stop) { Run(stop); }) {}

WatchHub::~WatchHub() = default;

std::shared_ptr<WatchHub::Watcher> WatchHub::Join(Wish wish, std::function<void()> on_news) {
  const std::lock_guard lock(mutex_);
  if (watchers_.size() >= kMaxWatchers) {
    throw Overloaded("watchers", "as many watch as may", std::chrono::seconds(1));
  }
  auto watcher = std::make_shared<Watcher>(std::move(wish), std::move(on_news), mail_bytes_);
  watchers_.push_back(watcher);
  num_watchers_ = static_cast<int>(watchers_.size());
  EnqueueAll();
  return watcher;
}

void WatchHub::Leave(const std::shared_ptr<Watcher>& watcher) {
  const std::lock_guard lock(mutex_);
  std::erase(watchers_, watcher);
  num_watchers_ = static_cast<int>(watchers_.size());
  EnqueueAll();
}

void WatchHub::Show(const std::string& name, const std::function<Sight(WatchParts)>& make) {
  if (!IsWatched()) return;
  WatchParts parts = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!IsWanted(name)) return;
    parts = PartsWanted(name);
  }
  auto sight = std::make_shared<Sight>(make(parts));
  const std::lock_guard lock(mutex_);
  Robot& robot = Of(name);
  const std::size_t bytes = sight->NumBytes();
  if (robot.newest) ++num_dropped_;
  Drop(robot);
  MakeRoom(bytes);
  sight->sequence = ++robot.sequence;
  robot.seen = Clock::now();
  robot.newest = std::move(sight);
  robot.bytes = bytes;
  pending_bytes_ += bytes;
  Enqueue(robot);
  has_news_ = true;
  changed_.notify_one();
}

WatchHub::Counts WatchHub::counts() const {
  const std::lock_guard lock(mutex_);
  return {.watchers = watchers_.size(),
          .waiting_bytes = pending_bytes_ + mail_bytes_,
          .shown = num_shown_,
          .dropped = num_dropped_};
}

bool WatchHub::IsWanted(const std::string& robot) const {
  return std::ranges::any_of(watchers_, [&](const auto& each) { return each->Covers(robot); });
}

WatchParts WatchHub::PartsWanted(const std::string& robot) const {
  WatchParts parts = 0;
  for (const auto& watcher : watchers_) {
    if (watcher->Covers(robot)) parts |= watcher->wish.parts;
  }
  return parts;
}

WatchHub::Robot& WatchHub::Of(const std::string& name) {
  const auto found = robots_.find(name);
  if (found != robots_.end()) return found->second;
  if (robots_.size() >= kMaxRobots) {
    const auto oldest =
        std::ranges::min_element(robots_, {}, [](const auto& each) { return each.second.seen; });
    Drop(oldest->second);
    for (const auto& watcher : watchers_) {
      watcher->turns.erase(oldest->first);
      watcher->mailbox.Forget(oldest->first);
    }
    robots_.erase(oldest);
  }
  return robots_[name];
}

void WatchHub::Drop(Robot& robot) {
  Dequeue(robot);
  pending_bytes_ -= std::exchange(robot.bytes, 0);
  robot.newest.reset();
}

// One frame always has room, however large; else those that wait longest make it.
void WatchHub::MakeRoom(std::size_t bytes) {
  while (pending_bytes_ > 0 && pending_bytes_ + bytes > kMaxPending) {
    Drop(*by_age_.begin()->second);
    ++num_dropped_;
  }
}

bool WatchHub::Watcher::Covers(const std::string& robot) {
  const auto known = covered_.find(robot);
  if (known != covered_.end()) return known->second;
  if (covered_.size() >= kMaxRobots) covered_.clear();
  return covered_.emplace(robot, wish.Covers(robot)).first->second;
}

WatchHub::Clock::time_point WatchHub::Watcher::DueOf(const Sight& sight) {
  if (wish.only_problems && !sight.IsProblem()) return Clock::time_point::max();
  if (!Covers(sight.robot)) return Clock::time_point::max();
  const auto turn = turns.find(sight.robot);
  if (turn == turns.end()) return Clock::time_point::min();
  return turn->second.shown < sight.sequence ? turn->second.due : Clock::time_point::max();
}

WatchHub::Clock::time_point WatchHub::DueOf(const Sight& sight) const {
  Clock::time_point due = Clock::time_point::max();
  for (const auto& watcher : watchers_) due = std::min(due, watcher->DueOf(sight));
  return due;
}

void WatchHub::Enqueue(Robot& robot) {
  Dequeue(robot);
  robot.due = DueOf(*robot.newest);
  if (robot.due == Clock::time_point::max()) return Drop(robot);
  by_due_.insert({robot.due, robot.seen, &robot});
  by_age_.insert({robot.seen, &robot});
}

void WatchHub::Dequeue(Robot& robot) {
  by_due_.erase({robot.due, robot.seen, &robot});
  by_age_.erase({robot.seen, &robot});
}

void WatchHub::EnqueueAll() {
  for (auto& [name, robot] : robots_) {
    if (robot.newest) Enqueue(robot);
  }
  has_news_ = true;
  changed_.notify_one();
}

WatchHub::Robot* WatchHub::NextDue(Clock::time_point now, Clock::time_point* next) const {
  *next = Clock::time_point::max();
  if (by_due_.empty()) return nullptr;
  const auto& [due, seen, robot] = *by_due_.begin();
  if (due <= now) return robot;
  *next = due;
  return nullptr;
}

std::vector<std::shared_ptr<WatchHub::Watcher>> WatchHub::TakeDue(const Sight& sight,
                                                                  Clock::time_point now) {
  std::vector<std::shared_ptr<Watcher>> takers;
  for (const auto& watcher : watchers_) {
    if (watcher->DueOf(sight) > now) continue;
    watcher->turns[sight.robot] = {.shown = sight.sequence, .due = now + watcher->wish.period};
    takers.push_back(watcher);
  }
  return takers;
}

void WatchHub::Await(const std::stop_token& stop, Clock::time_point next,
                     std::unique_lock<std::mutex>& lock) {
  const auto has_news = [this] { return has_news_; };
  if (next == Clock::time_point::max()) {
    changed_.wait(lock, stop, has_news);
  } else {
    changed_.wait_until(lock, stop, next, has_news);
  }
  has_news_ = false;
}

void WatchHub::Run(const std::stop_token& stop) {
  constexpr int kNicest = 19;
  LowerPriority(kNicest);
  while (!stop.stop_requested()) {
    try {
      Step(stop);
    } catch (...) {
      LogCurrentException("frames are not shown");
    }
  }
}

void WatchHub::Step(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const Clock::time_point now = Clock::now();
  Clock::time_point next;
  Robot* const robot = NextDue(now, &next);
  if (robot == nullptr) return Await(stop, next, lock);
  // It waits on for those who may have it only later, unless a newer one comes.
  const std::shared_ptr<const Sight> sight = robot->newest;
  const auto takers = TakeDue(*sight, now);
  Enqueue(*robot);
  lock.unlock();
  Deliver(*sight, takers);
}

void WatchHub::Deliver(const Sight& sight, const std::vector<std::shared_ptr<Watcher>>& watchers) {
  WatchedMessages messages(sight, max_pixels_);
  std::map<WatchParts, grpc::Slice> by_parts;
  for (const auto& watcher : watchers) {
    try {
      const WatchParts parts = watcher->wish.parts;
      const auto found = by_parts.find(parts);
      const grpc::Slice message = found != by_parts.end()
                                      ? found->second
                                      : by_parts.emplace(parts, messages.With(parts)).first->second;
      const bool has_room = watcher->mailbox.Put(sight.robot, sight.sequence, message);
      ++(has_room ? num_shown_ : num_dropped_);
      if (has_room) watcher->on_news();
    } catch (...) {
      LogCurrentException("a frame is not shown");
    }
  }
}

}  // namespace fovea::server
