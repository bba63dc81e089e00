#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/observer/watch_stream.h"
#include "fovea/v1/observation_service.pb.h"

namespace fovea::observer {

// One frame as it was shown, under a number that only this board gives.
struct ShownFrame {
  std::uint64_t id = 0;
  std::size_t server = 0;  // which one showed it
  std::uint64_t dropped = 0;
  std::uint64_t came_at_us = 0;  // here, since 1970
  v1::WatchedFrame frame = {};
};
using ShownFramePtr = std::shared_ptr<const ShownFrame>;

// How a robot is looked at: in the list of all, or closely, for its cloud with depth.
enum class Look { kList, kClose, kCloseWithDepth };

// What one who watches has seen last of each robot. Thread-safe; holds the newest frame of each
// robot, and some more of those that are looked at closely. Gives away what may be seen when it is
// asked, whatever it was let see before.
class Board {
 public:
  // Called with a lock held, from the threads that watch, when something has changed.
  using OnChange = std::function<void()>;

  explicit Board(std::vector<std::string> servers);

  void OnObserver(std::size_t server, const v1::Observer& observer);
  void OnState(std::size_t server, const LinkState& state);
  void OnFrame(std::size_t server, v1::WatchResponse response, Look look);
  // For the list: a frame from before, of a robot of which none has come since.
  void OnPast(std::size_t server, v1::WatchedFrame frame, std::uint64_t came_at_us);
  // Whether one has, or a later one from before is there.
  bool HasNewer(const std::string& robot, std::uint64_t came_at_us) const;
  // Nobody looks at it so any more, or somebody begins to, whom nothing from before concerns.
  void Forget(const std::string& robot, Look look);

  // What has changed since `version`, as JSON; empty where nothing has. Takes `version` forward.
  // `close` = of that robot, tell the frame that was looked at closely, in this way.
  std::string ChangesSince(std::uint64_t* version, const std::string& close, Look look) const;

  // Null where it is not there any more, or never was, or may not be seen any more.
  ShownFramePtr Frame(const std::string& robot, std::uint64_t id) const;
  // The same, or what a pick says of its objects where that is all that is left: of the last 300
  // frames that were looked at closely, and the last 20 of each robot that the list had.
  ShownFramePtr FrameToPickFrom(const std::string& robot, std::uint64_t id) const;

  // Whether the one who watches has this right, and `view`, over a robot of this server, as that
  // said when it let it in, and until it says otherwise.
  bool MayDo(const std::string& server, const std::string& robot, v1::ObserverRight right) const;
  const std::string& AddressOf(std::size_t server) const { return servers_.at(server).address; }

  // {"name": …, "rights": […], "robots": […]}; none where no server has let it in.
  std::optional<std::string> Who() const;
  // Whether each server has answered, or cannot.
  bool IsSettled() const;
  // Whether every server that could be reached refuses the token now.
  bool IsRefused() const;
  // Which server refuses it, and why it says that it does; of several the first. Empty where none
  // does.
  std::string Refusal() const;

  using Subscription = std::shared_ptr<void>;
  Subscription Subscribe(OnChange on_change);
  // Has all who listen look, though nothing has changed here.
  void WakeAll() const;

 private:
  struct Server {
    std::string address;
    LinkState state = {};
    std::optional<v1::Observer> observer = std::nullopt;
    std::uint64_t version = 0;
  };
  struct Arrival {
    std::chrono::steady_clock::time_point at;
    std::uint64_t sequence = 0;  // as the server counts its frames, shown or not
  };
  struct Robot {
    std::uint64_t version = 0;
    ShownFramePtr newest;
    std::map<Look, std::deque<ShownFramePtr>> close;
    std::deque<ShownFramePtr> listed;  // without pictures and masks
    std::deque<Arrival> arrivals;      // the last ones
    double rate_hz = 0;
  };

  static bool IsNewer(const Robot& robot, std::uint64_t came_at_us);
  static double RateOf(const std::deque<Arrival>& arrivals);
  static bool Allows(const Server& server, const std::string& robot, v1::ObserverRight right);
  // mutex_ is held for these.
  void Change(std::uint64_t* version);
  bool MaySee(const ShownFramePtr& shown) const;

  mutable std::mutex mutex_;
  std::uint64_t version_ = 0, last_id_ = 0;
  std::vector<Server> servers_;
  std::map<std::string, Robot> robots_;
  std::deque<ShownFramePtr> to_pick_from_;  // without pictures and masks
  std::list<OnChange> listeners_;
};

}  // namespace fovea::observer
