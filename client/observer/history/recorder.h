#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/observer/history/history.h"
#include "client/observer/server_link.h"
#include "client/observer/watch_stream.h"

namespace fovea::observer {

// Records what one token lets it see of all servers, with what robots sent where it may download.
// Thread-safe.
class Recorder {
 public:
  // `history` must outlive it.
  Recorder(const std::vector<ServerLink>& servers, const std::string& token, double rate_hz,
           History& history);

  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Why nothing is recorded now, or not of all servers; empty where all is well.
  std::string Problem() const;

 private:
  struct Server {
    std::string address, version = {};
    std::string problem = {};
  };

  WatchStream::Listener ListenerOf(std::size_t server);
  void OnFrame(std::size_t server, v1::WatchedFrame frame);
  void Say(std::string* where, const std::string& problem, const char* if_none = "goes on");

  History& history_;
  mutable std::mutex mutex_;
  std::vector<Server> servers_;
  std::string disk_problem_, shortage_;
  std::vector<std::unique_ptr<WatchStream>> streams_;  // last: they use all of the above
};

}  // namespace fovea::observer
