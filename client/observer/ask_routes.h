#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "client/observer/feed.h"
#include "client/observer/history/history_routes.h"
#include "client/observer/http_types.h"

namespace fovea::observer {

// What is asked of servers for a session, with its token: the options that there are, what they
// would answer with others, and picks for robots. Thread-safe.
class AskRoutes {
 public:
  explicit AskRoutes(HistoryRoutes history) : history_(std::move(history)) {}

  static bool IsOne(const std::string& path);
  HttpResponse Answer(const HttpRequest& request, Feed& feed);
  // What is asked is answered at once from now on, by an error.
  void End() { end_.request_stop(); }

 private:
  // A frame that the page names, and the server that answered it.
  struct Named {
    std::string server;
    v1::WatchedFrame frame;
  };

  HttpResponse Options(const HttpRequest& request, Feed& feed) const;
  HttpResponse TryFrame(const HttpRequest& request, Feed& feed) const;
  HttpResponse Pick(const HttpRequest& request, Feed& feed) const;
  std::optional<Named> Find(const std::string& robot, std::uint64_t id, bool past,
                            const Board& board, v1::ObserverRight right) const;

  const HistoryRoutes history_;
  std::atomic<int> num_asked_ = 0;
  std::stop_source end_;
};

}  // namespace fovea::observer
