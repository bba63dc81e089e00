#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "client/observer/server_link.h"
#include "fovea/v1/observation_service.pb.h"

namespace fovea::observer {

// How it stands with one server.
struct LinkState {
  // Connecting: it has not answered yet, or has taken back what it answered and is asked anew.
  enum class Kind { kConnecting, kWatching, kAway, kRefused };
  Kind kind = Kind::kConnecting;
  std::string problem = {};  // in words, where it is away, or has refused
};

// Watches one server for as long as it lives, again and again where that is needed, with a thread
// of its own, from which the functions are called.
class WatchStream {
 public:
  struct Listener {
    std::function<void(const v1::Observer&)> on_observer;
    std::function<void(v1::WatchResponse)> on_frame;
    std::function<void(const LinkState&)> on_state;
  };

  WatchStream(ServerLink link, std::string token, v1::WatchRequest request, Listener listener);
  // Waits for a function of the listener that is being called, after which none is, but not for the
  // thread, which may wait for a connection.
  ~WatchStream();

  WatchStream(const WatchStream&) = delete;
  WatchStream& operator=(const WatchStream&) = delete;

 private:
  class Watching;

  const std::shared_ptr<Watching> watching_;  // the thread's, too
  std::jthread thread_;
};

}  // namespace fovea::observer
