#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace fovea::capture {

// Lines for people.
std::string AwayNote(const std::string& server);
std::string BackNote(const std::string& server);

// Notices that frames get no answers: because the server is away, or though it is there. Says so
// once, and once that it is back. Thread-safe.
class OutageWatch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // `server` is for people.
  explicit OutageWatch(std::string server) : server_(std::move(server)) {}

  // Before a frame is sent, which may wait for a server that takes nothing in.
  void Sending(Time now);
  // Whether the connection took it.
  void Sent(bool was_taken);
  // The frame with this number among those sent.
  void Answered(std::uint64_t sequence, Time now);

  // A line for people where something changed; else empty.
  std::string Take(Time now);

 private:
  const std::string server_;
  std::mutex mutex_;
  std::optional<Time> waiting_since_;  // for the next answer; none = no frame waits
  std::chrono::seconds longest_silence_{3};
  std::uint64_t num_sent_ = 0;
  bool is_broken_ = false;  // the connection did not take the last frame
  bool is_out_ = false;     // as was said last
  bool answered_ = false;   // since then
};

}  // namespace fovea::capture
