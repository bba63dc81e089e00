#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "client/observer/board.h"
#include "client/observer/history/history.h"
#include "client/observer/server_link.h"
#include "client/observer/watch_stream.h"

namespace fovea::observer {

// All that one token lets its owner see, of all servers, however many browsers show it.
// Thread-safe.
class Feed {
 public:
  // `history` may be null, and must outlive this: of robots that send nothing its newest frames are
  // shown.
  Feed(const std::vector<ServerLink>& servers, std::string token, const History* history = nullptr);

  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

  Board& board() { return board_; }
  const std::vector<ServerLink>& servers() const { return servers_; }
  const std::string& token() const { return token_; }

  // Looks at one robot closely, with whole pictures and more often, as long as this is held. Null
  // where as many are looked at as may.
  using CloseLook = std::shared_ptr<void>;
  CloseLook LookAt(const std::string& robot, bool with_depth);

  // Until each server has answered, or cannot, or the time is over.
  void AwaitAnswer(std::chrono::milliseconds patience);

 private:
  using Streams = std::vector<std::unique_ptr<WatchStream>>;

  void OnObserver(std::size_t server, const v1::Observer& who);
  Streams Watch(const v1::WatchRequest& request, Look look);
  void EndLook(const std::string& key, const std::string& robot, Look look);

  const std::vector<ServerLink> servers_;
  const std::string token_;
  const History* const history_;
  Board board_;
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<void>> close_;  // by robot and whether with depth
  Streams streams_;
};

}  // namespace fovea::observer
