#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/observer/feed.h"

namespace fovea::observer {

// A browser that has logged in.
struct Session {
  std::string id;    // in its cookie
  std::string csrf;  // in a header of what changes something
  std::shared_ptr<Feed> feed;
  std::chrono::steady_clock::time_point used;
  // For what goes on without asking again; the feed's board wakes it.
  std::shared_ptr<std::atomic<bool>> has_ended = std::make_shared<std::atomic<bool>>(false);
};

// Thread-safe. Bounded: the session that was not used for longest makes room for another one.
class Sessions {
 public:
  // `history` may be null, and must outlive this.
  Sessions(std::vector<ServerLink> servers, const History* history)
      : servers_(std::move(servers)), history_(history) {}

  // Waits for the servers, some seconds at most. None where none of them knows the token, when
  // `problem` says why.
  std::optional<Session> LogIn(const std::string& token, std::string* problem);
  // None where there is no such session (any more), or its token has been taken back.
  std::optional<Session> Find(const std::string& id);
  void LogOut(const std::string& id);

 private:
  using Map = std::map<std::string, Session>;  // by id

  std::shared_ptr<Feed> FeedOf(const std::string& token);
  void End(Map::iterator session);  // mutex_ is held

  const std::vector<ServerLink> servers_;
  const History* const history_;
  std::mutex mutex_;
  Map sessions_;
  std::map<std::string, std::weak_ptr<Feed>> feeds_;  // by token
};

// 256 random bits, in hexadecimal digits.
std::string RandomName();

}  // namespace fovea::observer
