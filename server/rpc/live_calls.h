// The calls that are under way, so that the server can end them and wait for the last.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace fovea::server {

class LiveCalls {
 public:
  // A call holds this as long as it lives.
  using Token = std::shared_ptr<void>;
  Token Enter();

  // `end` is called by EndStreams() for as long as the token it returns lives; null once streams
  // have been ended.
  Token EnterStream(std::function<void()> end);

  // Streams end after the answer they are at; new ones are refused.
  void EndStreams();
  void WaitUntilNone();

 private:
  std::mutex mutex_;
  std::condition_variable none_;
  int num_calls_ = 0;
  bool streams_end_ = false;
  int next_stream_ = 0;
  std::map<int, std::function<void()>> streams_;
};

}  // namespace fovea::server
