#include "client/observer/board.h"

#include <fnmatch.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "client/observer/board_json.h"
#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxRobots = 1024, kListed = 20, kToPickFrom = 300;

// Of those that are looked at closely. A slow connection asks for what it was told seconds ago.
constexpr std::uint64_t kCloseUs = 3'000'000;
constexpr std::size_t kCloseBytes = std::size_t{16} << 20, kLeastClose = 4;

// Since 1970.
std::uint64_t NowUs() {
  using std::chrono::microseconds, std::chrono::system_clock;
  const auto now = std::chrono::floor<microseconds>(system_clock::now());
  return static_cast<std::uint64_t>(now.time_since_epoch().count());
}

bool Has(const v1::Observer& observer, v1::ObserverRight right) {
  return std::ranges::find(observer.rights(), right) != observer.rights().end();
}

// As the server does it.
bool Covers(const v1::Observer& observer, const std::string& robot) {
  return std::ranges::any_of(observer.robots(), [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), robot.c_str(), 0) == 0;
  });
}

bool IsValid(const v1::Observer& observer) {
  return !observer.has_expires() ||
         google::protobuf::util::TimeUtil::GetCurrentTime() < observer.expires();
}

// A page shows frames for longer than all of them can be kept here.
ShownFramePtr ToPickFrom(const ShownFrame& shown) {
  auto light = std::make_shared<ShownFrame>();
  light->id = shown.id;
  light->server = shown.server;
  light->frame.set_robot(shown.frame.robot());
  light->frame.set_frame_id(shown.frame.frame_id());
  *light->frame.mutable_answered_at() = shown.frame.answered_at();
  for (const v1::Object& object : shown.frame.detections().objects()) {
    v1::Object& kept = *light->frame.mutable_detections()->add_objects();
    kept.set_label(object.label());
    kept.set_track_id(object.track_id());
    *kept.mutable_oriented_box() = object.oriented_box();
  }
  return light;
}

void DropOld(std::deque<ShownFramePtr>* frames) {
  const auto bytes_with = [](std::size_t sum, const ShownFramePtr& each) {
    return sum + each->frame.picture().size() + each->frame.depth().data().size();
  };
  const auto is_too_much = [&] {
    return frames->back()->came_at_us - frames->front()->came_at_us > kCloseUs ||
           std::accumulate(frames->begin(), frames->end(), std::size_t{0}, bytes_with) >
               kCloseBytes;
  };
  while (frames->size() > kLeastClose && is_too_much()) frames->pop_front();
}

}  // namespace

Board::Board(std::vector<std::string> servers) {
  for (std::string& address : servers) servers_.push_back({.address = std::move(address)});
}

// Frames that were answered, shown or not, a second.
double Board::RateOf(const std::deque<Arrival>& arrivals) {
  if (arrivals.size() < 2) return 0;
  const std::chrono::duration<double> span = arrivals.back().at - arrivals.front().at;
  const auto frames = static_cast<double>(arrivals.back().sequence - arrivals.front().sequence);
  return span.count() > 0 ? frames / span.count() : 0;
}

void Board::Change(std::uint64_t* version) {
  *version = ++version_;
  for (const OnChange& on_change : listeners_) on_change();
}

void Board::OnObserver(std::size_t server, const v1::Observer& observer) {
  const std::lock_guard lock(mutex_);
  servers_.at(server).observer = observer;
  Change(&servers_[server].version);
}

void Board::OnState(std::size_t server, const LinkState& state) {
  const std::lock_guard lock(mutex_);
  servers_.at(server).state = state;
  const bool is_taken_back =
      state.kind == LinkState::Kind::kRefused || state.kind == LinkState::Kind::kConnecting;
  if (is_taken_back) servers_[server].observer.reset();
  Change(&servers_[server].version);
}

void Board::OnFrame(std::size_t server, v1::WatchResponse response, Look look) {
  constexpr std::size_t kArrivals = 10;
  auto shown = std::make_shared<ShownFrame>();
  shown->server = server;
  shown->dropped = response.dropped();
  shown->came_at_us = NowUs();
  shown->frame = std::move(*response.mutable_frame());
  const std::lock_guard lock(mutex_);
  shown->id = ++last_id_;
  const std::string& name = shown->frame.robot();
  if (!robots_.contains(name) && robots_.size() >= kMaxRobots) {
    robots_.erase(std::ranges::min_element(robots_, {},
                                           [](const auto& each) { return each.second.version; }));
  }
  Robot& robot = robots_[name];
  if (look != Look::kList) {
    std::deque<ShownFramePtr>& close = robot.close[look];
    close.push_back(shown);
    DropOld(&close);
    to_pick_from_.push_back(ToPickFrom(*shown));
    if (to_pick_from_.size() > kToPickFrom) to_pick_from_.pop_front();
  } else {
    robot.newest = shown;
    robot.listed.push_back(ToPickFrom(*shown));
    if (robot.listed.size() > kListed) robot.listed.pop_front();
    // A server that has started anew counts from the beginning.
    const std::uint64_t sequence = shown->frame.sequence();
    if (!robot.arrivals.empty() && sequence <= robot.arrivals.back().sequence) {
      robot.arrivals.clear();
    }
    robot.arrivals.push_back({.at = Clock::now(), .sequence = sequence});
    if (robot.arrivals.size() > kArrivals) robot.arrivals.pop_front();
    robot.rate_hz = RateOf(robot.arrivals);
  }
  Change(&robot.version);
}

bool Board::IsNewer(const Robot& robot, std::uint64_t came_at_us) {
  return !robot.arrivals.empty() || (robot.newest && robot.newest->came_at_us >= came_at_us);
}

bool Board::HasNewer(const std::string& robot, std::uint64_t came_at_us) const {
  const std::lock_guard lock(mutex_);
  const auto found = robots_.find(robot);
  return found != robots_.end() && IsNewer(found->second, came_at_us);
}

void Board::OnPast(std::size_t server, v1::WatchedFrame frame, std::uint64_t came_at_us) {
  auto shown = std::make_shared<ShownFrame>();
  shown->server = server;
  shown->came_at_us = came_at_us;
  shown->frame = std::move(frame);
  const std::lock_guard lock(mutex_);
  const std::string& name = shown->frame.robot();
  if (!robots_.contains(name) && robots_.size() >= kMaxRobots) return;
  Robot& robot = robots_[name];
  if (IsNewer(robot, came_at_us)) return;  // it came meanwhile
  shown->id = ++last_id_;
  robot.newest = std::move(shown);
  Change(&robot.version);
}

void Board::Forget(const std::string& robot, Look look) {
  const std::lock_guard lock(mutex_);
  if (const auto found = robots_.find(robot); found != robots_.end()) {
    found->second.close.erase(look);
  }
}

std::string Board::ChangesSince(std::uint64_t* version, const std::string& close, Look look) const {
  const std::lock_guard lock(mutex_);
  if (*version == version_) return {};
  nlohmann::json changes{{"now_us", NowUs()},
                         {"servers", nlohmann::json::array()},
                         {"robots", nlohmann::json::array()}};
  for (const Server& server : servers_) {
    changes["servers"].push_back(
        ServerJson(server.address, server.state, server.observer ? &*server.observer : nullptr));
  }
  for (const auto& [name, robot] : robots_) {
    if (robot.version <= *version) continue;
    if (MaySee(robot.newest)) changes["robots"].push_back(RobotJson(*robot.newest, robot.rate_hz));
    const auto frames = robot.close.find(look);
    if (name != close || frames == robot.close.end()) continue;
    const ShownFramePtr& shown = frames->second.back();
    if (MaySee(shown)) changes["close"] = RobotJson(*shown, robot.rate_hz);
  }
  *version = version_;
  return JsonText(changes);
}

ShownFramePtr Board::Frame(const std::string& robot, std::uint64_t id) const {
  const std::lock_guard lock(mutex_);
  const auto found = robots_.find(robot);
  if (found == robots_.end()) return nullptr;
  for (const auto& [look, frames] : found->second.close) {
    for (const ShownFramePtr& each : frames) {
      if (each->id == id) return MaySee(each) ? each : nullptr;
    }
  }
  const ShownFramePtr& newest = found->second.newest;
  return newest && newest->id == id && MaySee(newest) ? newest : nullptr;
}

ShownFramePtr Board::FrameToPickFrom(const std::string& robot, std::uint64_t id) const {
  if (ShownFramePtr whole = Frame(robot, id)) return whole;
  const std::lock_guard lock(mutex_);
  const auto with_id = [id](const ShownFramePtr& each) { return each->id == id; };
  auto found = std::ranges::find_if(to_pick_from_, with_id);
  if (found == to_pick_from_.end()) {
    const auto listed = robots_.find(robot);
    if (listed == robots_.end()) return nullptr;
    found = std::ranges::find_if(listed->second.listed, with_id);
    if (found == listed->second.listed.end()) return nullptr;
  }
  return (*found)->frame.robot() == robot && MaySee(*found) ? *found : nullptr;
}

bool Board::MayDo(const std::string& address, const std::string& robot,
                  v1::ObserverRight right) const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(servers_, [&](const Server& server) {
    return server.address == address && Allows(server, robot, right);
  });
}

bool Board::Allows(const Server& server, const std::string& robot, v1::ObserverRight right) {
  return server.observer && IsValid(*server.observer) &&
         Has(*server.observer, v1::OBSERVER_RIGHT_VIEW) && Has(*server.observer, right) &&
         Covers(*server.observer, robot);
}

bool Board::MaySee(const ShownFramePtr& shown) const {
  return shown && Allows(servers_.at(shown->server), shown->frame.robot(), v1::OBSERVER_RIGHT_VIEW);
}

std::optional<std::string> Board::Who() const {
  const std::lock_guard lock(mutex_);
  for (const Server& server : servers_) {
    if (server.observer) return JsonText(ObserverJson(*server.observer));
  }
  return std::nullopt;
}

bool Board::IsSettled() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::none_of(servers_, [](const Server& server) {
    return server.state.kind == LinkState::Kind::kConnecting && !server.observer;
  });
}

bool Board::IsRefused() const {
  const std::lock_guard lock(mutex_);
  const auto is = [](LinkState::Kind kind) {
    return [kind](const Server& server) { return server.state.kind == kind; };
  };
  return std::ranges::any_of(servers_, is(LinkState::Kind::kRefused)) &&
         std::ranges::none_of(servers_, is(LinkState::Kind::kWatching)) &&
         std::ranges::none_of(servers_, is(LinkState::Kind::kConnecting)) &&
         std::ranges::none_of(servers_,
                              [](const Server& each) { return each.observer.has_value(); });
}

std::string Board::Refusal() const {
  const std::lock_guard lock(mutex_);
  for (const Server& server : servers_) {
    if (server.state.kind != LinkState::Kind::kRefused) continue;
    return server.address + ": " + server.state.problem;
  }
  return {};
}

void Board::WakeAll() const {
  const std::lock_guard lock(mutex_);
  for (const OnChange& on_change : listeners_) on_change();
}

Board::Subscription Board::Subscribe(OnChange on_change) {
  const std::lock_guard lock(mutex_);
  listeners_.push_back(std::move(on_change));
  return {this, [this, place = std::prev(listeners_.end())](Board*) {
            const std::lock_guard inner(mutex_);
            listeners_.erase(place);
          }};
}

}  // namespace fovea::observer
