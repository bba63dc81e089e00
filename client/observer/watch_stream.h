#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
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

  WatchStream(const WatchStream&) = delete;
  WatchStream& operator=(const WatchStream&) = delete;

 private:
  void Run(const std::stop_token& stop);
  void Pause(const std::stop_token& stop, std::chrono::milliseconds wait);
  bool Watch(const std::stop_token& stop);  // whether anything came

  const ServerLink link_;
  const std::string token_;
  const v1::WatchRequest request_;
  const Listener listener_;
  std::mutex mutex_;
  std::condition_variable_any pause_;
  std::jthread thread_;
};

}  // namespace fovea::observer
