#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "server/observing/mailbox.h"
#include "server/observing/sight.h"
#include "server/observing/wish.h"

namespace fovea::server {

// Brings frames from those who compute them to those who watch. Computing waits for nobody: a frame
// is handed over, and pictures are made of it by a thread that gives way to all others. Of each
// robot only the newest frame waits, and all that waits is bounded. Thread-safe.
class WatchHub {
 public:
  // One who watches. `on_news` is called, from the hub's thread, when the mailbox got something.
  struct Watcher {
    Watcher(Wish w, std::function<void()> news, std::atomic<std::size_t>& total);
    const Wish wish;
    const std::function<void()> on_news;
    Mailbox mailbox;
    // Of each robot, what was shown last and when the next one may be; the hub's.
    struct Turn {
      std::uint64_t shown = 0;
      std::chrono::steady_clock::time_point due;
    };
    std::map<std::string, Turn> turns;

    // Whether it is to see this robot. Patterns may be many and long, and frames wait while they
    // are matched, so that is done once for each robot.
    bool Covers(const std::string& robot);

    // When this may be shown; max() = never, or it has been.
    std::chrono::steady_clock::time_point DueOf(const Sight& sight);

   private:
    std::map<std::string, bool> covered_;  // the hub's, too
  };
  struct Counts {
    std::size_t watchers = 0, waiting_bytes = 0;
    std::uint64_t shown = 0, dropped = 0;
  };

  explicit WatchHub(std::uint64_t max_pixels);
  ~WatchHub();

  WatchHub(const WatchHub&) = delete;
  WatchHub& operator=(const WatchHub&) = delete;

  // Whether there is anybody; costs one read.
  bool IsWatched() const { return num_watchers_.load(std::memory_order_relaxed) > 0; }

  // Shows what `make` makes, which is asked only where somebody wants it, with the parts that
  // anybody wants. `robot` must be its name.
  void Show(const std::string& robot, const std::function<Sight(WatchParts)>& make);

  // Throws Overloaded where too many watch already.
  std::shared_ptr<Watcher> Join(Wish wish, std::function<void()> on_news);
  void Leave(const std::shared_ptr<Watcher>& watcher);

  Counts counts() const;

 private:
  using Clock = std::chrono::steady_clock;

  struct Robot {
    std::uint64_t sequence = 0;
    Clock::time_point seen;
    std::shared_ptr<const Sight> newest;  // waits to be shown
    std::size_t bytes = 0;                // of that
    Clock::time_point due;                // of the first of those who want it
  };

  // mutex_ is held for these.
  bool IsWanted(const std::string& robot) const;
  WatchParts PartsWanted(const std::string& robot) const;
  Robot& Of(const std::string& robot);
  void Drop(Robot& robot);
  void MakeRoom(std::size_t bytes);
  Clock::time_point DueOf(const Sight& sight) const;  // of the first of those who want it
  // Puts what waits of the robot where it belongs, or drops it where all who want it have it.
  void Enqueue(Robot& robot);
  void Dequeue(Robot& robot);
  void EnqueueAll();  // who watches is another
  // The robot to show now; null where none is due, when `*next` is the time to look again.
  Robot* NextDue(Clock::time_point now, Clock::time_point* next) const;
  std::vector<std::shared_ptr<Watcher>> TakeDue(const Sight& sight, Clock::time_point now);
  void Await(const std::stop_token& stop, Clock::time_point next,
             std::unique_lock<std::mutex>& lock);

  void Run(const std::stop_token& stop);
  void Step(const std::stop_token& stop);
  void Deliver(const Sight& sight, const std::vector<std::shared_ptr<Watcher>>& watchers);

  const std::uint64_t max_pixels_;
  std::atomic<int> num_watchers_ = 0;
  std::atomic<std::size_t> mail_bytes_ = 0;
  std::atomic<std::uint64_t> num_shown_ = 0, num_dropped_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  bool has_news_ = false;
  std::vector<std::shared_ptr<Watcher>> watchers_;
  std::map<std::string, Robot> robots_;
  // Of what waits: the first to be shown, and the first to make room. A step costs time in
  // proportion to those who watch, however many robots there are.
  std::set<std::tuple<Clock::time_point, Clock::time_point, Robot*>> by_due_;  // and when it came
  std::set<std::pair<Clock::time_point, Robot*>> by_age_;
  std::size_t pending_bytes_ = 0;
  std::jthread thread_;
};

}  // namespace fovea::server
