#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/http/http_post.h"
#include "server/tracing/span.h"

namespace fovea::server {

// Sends spans to a collector, from a thread of its own: frames never wait for it. What a collector
// that is away or slow, or refuses it, does not take is dropped and counted.
class TraceExporter {
 public:
  explicit TraceExporter(HttpUrl url);
  // Sends what is left, for half a second at most.
  ~TraceExporter();

  TraceExporter(const TraceExporter&) = delete;
  TraceExporter& operator=(const TraceExporter&) = delete;

  // Thread-safe; takes no time.
  void Add(FrameSpans frame);

  // Frames, since the start. Of spans that are refused it is not said which frames they are of:
  // their share of the spans sent, rounded up, counts as dropped.
  std::uint64_t num_sent() const { return num_sent_; }
  std::uint64_t num_dropped() const { return num_dropped_; }

 private:
  void Run(const std::stop_token& stop);
  std::vector<FrameSpans> Take(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
  // How many were dropped.
  std::size_t Send(const std::vector<FrameSpans>& frames, const std::stop_token& stop);
  enum class Taken { kAll, kSome, kNone };
  void Tell(Taken taken, const std::string& problem);

  const HttpUrl url_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<FrameSpans> waiting_;
  std::atomic<std::uint64_t> num_sent_ = 0, num_dropped_ = 0;
  Taken taken_ = Taken::kAll;  // of the last that were sent; of the thread
  std::jthread thread_;
};

}  // namespace fovea::server
