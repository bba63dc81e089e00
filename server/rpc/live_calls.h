// The calls that are under way, so that the server can end them and wait for the last.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace fovea::server {

class LiveCalls {
 public:
  // A call holds these as long as it lives.
  using Token = std::shared_ptr<void>;

  // For one that is waited for.
  Token Enter();
  // For one that has begun; null once the server stops. `on_stop` is called by Stop(), `on_check`
  // by Check().
  Token Begin(
      std::function<void()> on_stop, std::function<void()> on_check = [] {});

  // Has those that have begun see whether they may go on.
  void Check();

  // No more calls begin.
  void Stop();
  // Those that are left are about to be cancelled; how many have begun.
  std::size_t GiveUp();
  bool given_up() const { return given_up_; }
  // Until no call is left that has begun, or the time has come.
  void WaitUntilIdle(std::chrono::steady_clock::time_point deadline);
  void WaitUntilNone();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int num_entered_ = 0;
  bool stopping_ = false;
  std::atomic<bool> given_up_ = false;
  std::uint64_t last_id_ = 0;

  struct Begun {
    std::function<void()> on_stop, on_check;
  };
  std::map<std::uint64_t, Begun> begun_;
};

}  // namespace fovea::server
