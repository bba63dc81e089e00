#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace fovea::server {

// What one connection may hold of the server's memory by sending messages in part. gRPC 1.51 has no
// limit for that: it takes what comes for every call of a connection until each message is whole.
struct AccountLimits {
  // Bytes of a connection that no message has come of yet.
  std::size_t max_owed = std::size_t{64} << 20;
  // How long it may owe some before a message has to come.
  std::chrono::seconds max_transfer{30};
};

// Of one connection: what has come, less the messages that it made. Not thread-safe.
class ConnectionAccount {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ConnectionAccount(Clock::time_point accepted)
      : accepted_(accepted), seen_(accepted), second_(accepted), calls_since_(accepted) {}

  // `total` bytes at least have come over the connection so far. May be less than what was said
  // before, which holds then.
  void OnReceived(std::uint64_t total, Clock::time_point now);
  // Of these, a message of so many. What was received has to be said before.
  void OnMessage(std::size_t bytes, Clock::time_point now);
  // The peer has taken a message of so many bytes: it says that it did, of which nothing is owed.
  void OnSent(std::size_t bytes);
  // A call on it was let in.
  void Admit() { admitted_ = true; }

  // A call's message may come from now on, or the next one of those that it has. Returns from which
  // byte on: by that number the call is known when it reads no more.
  std::uint64_t BeginReading();
  // The call has its message, and holds nothing of another one.
  void EndReading(std::uint64_t since);
  // The call ended before its message was whole: what came since is given back, and so is what its
  // caller sends until it hears of that. Where others read it may as well be theirs, and counts
  // until each of them has had a message or has ended.
  void Forgive(std::uint64_t since);
  // So many calls were begun on it so far; `max_calls_s` may be, once one was let in.
  void OnBegunCalls(std::uint64_t total, std::uint64_t max_calls_s, Clock::time_point now);

  bool admitted() const { return admitted_; }
  Clock::time_point accepted() const { return accepted_; }
  std::uint64_t owed() const { return owed_ + unsure_; }
  // The least that it owed in the last second or two: a robot's frames come whole again and again,
  // however many it sends.
  std::uint64_t held() const { return std::min(least_before_, least_); }
  // For how long it has owed more than a call's first bytes, since the last message.
  Clock::duration Owing(Clock::time_point now) const;

  // Whether so many calls were begun, or so much came without a call that was let in, that its host
  // had better stay away for a while.
  bool IsFlooding() const;

  // Why the connection has to go; empty where it may stay.
  std::optional<std::string> Fault(const AccountLimits& limits, Clock::time_point now) const;

 private:
  void NoteLeast(Clock::time_point now);
  void ForgetWhatNobodyHolds();

  Clock::time_point accepted_;
  Clock::time_point seen_;  // when what came was said last
  std::optional<Clock::time_point> owing_since_;
  std::uint64_t total_ = 0;
  std::uint64_t owed_ = 0;
  std::uint64_t unsure_ = 0;                    // of calls that ended, or of those that read
  std::multiset<std::uint64_t> reading_;        // since when each call does
  std::uint64_t replies_ = 0;                   // what may still come of messages sent to it
  std::uint64_t late_ = 0;                      // what may still come of calls that ended
  std::uint64_t least_before_ = 0, least_ = 0;  // of owed(), in the second before and in this one
  Clock::time_point second_;                    // when this one began
  std::uint64_t calls_ = 0, calls_before_ = 0;  // begun, and those before the second that began
  Clock::time_point calls_since_;               // then
  bool floods_ = false;                         // by more calls than may be
  bool admitted_ = false;
};

}  // namespace fovea::server
