#include "client/observer/feed.h"

#include <condition_variable>
#include <utility>

#include "client/observer/history/past.h"

namespace fovea::observer {
namespace {

constexpr double kListRateHz = 2, kCloseRateHz = 10;
constexpr std::size_t kMaxClose = 24;

std::vector<std::string> AddressesOf(const std::vector<ServerLink>& servers) {
  std::vector<std::string> addresses;
  addresses.reserve(servers.size());
  for (const ServerLink& server : servers) addresses.push_back(server.address);
  return addresses;
}

// A pattern that matches this name alone.
std::string PatternOf(const std::string& name) {
  std::string pattern;
  for (const char c : name) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') pattern += '\\';
    pattern += c;
  }
  return pattern;
}

v1::WatchRequest ListRequest() {
  v1::WatchRequest request;
  request.set_max_rate_hz(kListRateHz);
  request.add_parts(v1::WATCH_PART_ANSWER);
  request.add_parts(v1::WATCH_PART_PREVIEW);
  return request;
}

v1::WatchRequest CloseRequest(const std::string& robot, bool with_depth) {
  v1::WatchRequest request;
  request.add_robots(PatternOf(robot));
  request.set_max_rate_hz(kCloseRateHz);
  request.add_parts(v1::WATCH_PART_ANSWER);
  request.add_parts(v1::WATCH_PART_PICTURE);
  if (with_depth) request.add_parts(v1::WATCH_PART_DEPTH);
  return request;
}

}  // namespace

Feed::Feed(const std::vector<ServerLink>& servers, std::string token, const History* history)
    : servers_(servers), token_(std::move(token)), history_(history), board_(AddressesOf(servers)) {
  streams_ = Watch(ListRequest(), Look::kList);
}

void Feed::OnObserver(std::size_t server, const v1::Observer& who) {
  board_.OnObserver(server, who);
  if (history_ != nullptr) ShowPast(*history_, server, &board_);
}

Feed::Streams Feed::Watch(const v1::WatchRequest& request, Look look) {
  Streams streams;
  for (std::size_t i = 0; i < servers_.size(); ++i) {
    WatchStream::Listener listener{
        .on_observer = [this, i](const v1::Observer& who) { OnObserver(i, who); },
        .on_frame =
            [this, i, look](v1::WatchResponse response) {
              board_.OnFrame(i, std::move(response), look);
            },
        .on_state = [this, i](const LinkState& state) { board_.OnState(i, state); }};
    if (look != Look::kList) {  // how it stands with the server, the list says
      listener.on_observer = [](const v1::Observer&) {};
      listener.on_state = [](const LinkState&) {};
    }
    streams.push_back(
        std::make_unique<WatchStream>(servers_[i], token_, request, std::move(listener)));
  }
  return streams;
}

Feed::CloseLook Feed::LookAt(const std::string& robot, bool with_depth) {
  const std::string key = (with_depth ? "d" : "p") + robot;
  const std::lock_guard lock(mutex_);
  std::erase_if(close_, [](const auto& each) { return each.second.expired(); });
  if (const auto found = close_.find(key); found != close_.end()) {
    if (auto look = found->second.lock()) return look;
  }
  if (close_.size() >= kMaxClose) return nullptr;
  const Look look = with_depth ? Look::kCloseWithDepth : Look::kClose;
  board_.Forget(robot, look);
  auto streams = std::make_unique<Streams>(Watch(CloseRequest(robot, with_depth), look));
  CloseLook held(streams.release(), [this, key, robot, look](Streams* each) {
    delete each;
    EndLook(key, robot, look);
  });
  close_[key] = held;
  return held;
}

// What was kept for it takes memory.
void Feed::EndLook(const std::string& key, const std::string& robot, Look look) {
  const std::lock_guard lock(mutex_);
  const auto found = close_.find(key);
  const bool is_held_anew = found != close_.end() && !found->second.expired();
  if (!is_held_anew) board_.Forget(robot, look);
}

void Feed::AwaitAnswer(std::chrono::milliseconds patience) {
  std::mutex mutex;
  std::condition_variable changed;
  bool has_changed = false;
  const auto subscription = board_.Subscribe([&] {
    const std::lock_guard lock(mutex);
    has_changed = true;
    changed.notify_one();
  });
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!board_.IsSettled()) {
    std::unique_lock lock(mutex);
    if (!changed.wait_until(lock, end, [&] { return std::exchange(has_changed, false); })) return;
  }
}

}  // namespace fovea::observer
