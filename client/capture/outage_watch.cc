#include "client/capture/outage_watch.h"

namespace fovea::capture {

std::string AwayNote(const std::string& server) {
  return "the server at " + server + " is away; waiting for it to come back\n";
}

std::string BackNote(const std::string& server) { return "the server at " + server + " is back\n"; }

void OutageWatch::Sending(Time now) {
  const std::lock_guard lock(mutex_);
  ++num_sent_;
  if (!waiting_since_) waiting_since_ = now;
}

void OutageWatch::Sent(bool was_taken) {
  const std::lock_guard lock(mutex_);
  is_broken_ = !was_taken;
}

void OutageWatch::Answered(std::uint64_t sequence, Time now) {
  const std::lock_guard lock(mutex_);
  answered_ = true;
  waiting_since_.reset();
  if (sequence + 1 < num_sent_) waiting_since_ = now;
}

std::string OutageWatch::Take(Time now) {
  // A stream that goes on at another server is broken for a moment, too.
  constexpr std::chrono::seconds kLongestBreak{1};
  const std::lock_guard lock(mutex_);
  if (is_out_ && answered_) {
    is_out_ = false;
    return BackNote(server_);
  }
  const std::chrono::seconds limit = is_broken_ ? kLongestBreak : longest_silence_;
  if (is_out_ || !waiting_since_ || now - *waiting_since_ < limit) return "";
  is_out_ = true;
  answered_ = false;
  if (is_broken_) return AwayNote(server_);
  longest_silence_ *= 2;  // a server that is slow is not out with each frame
  return "the server at " + server_ + " has not answered for " + std::to_string(limit.count()) +
         " s; waiting\n";
}

}  // namespace fovea::capture
