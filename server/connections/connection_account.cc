#include "server/connections/connection_account.h"

#include <algorithm>
#include <utility>

namespace fovea::server {
namespace {

// Frames of HTTP/2 and records of TLS around a message, and the headers of its call.
constexpr double kOverheadShare = 0.02;
constexpr std::uint64_t kOverheadOfCall = 512;
// Calls without a message of ours, pings: what may come for these without a debt.
constexpr double kSmallTalk_bytes_s = 1024;
// A call's first bytes come before it is let in.
constexpr std::uint64_t kFirstBytes = std::uint64_t{128} << 10;
constexpr std::uint64_t kMaxLate = 4 * kFirstBytes;
// Window updates and pings that come for a message that is taken, with TLS.
constexpr std::uint64_t kReply = 128, kBytesOfMessageByReply = 256;
constexpr std::uint64_t kMaxReplies = std::uint64_t{64} << 10;
// Nobody was let in there: enough to ask for the health or to begin some calls.
constexpr std::uint64_t kMaxOwedByStranger = std::uint64_t{1} << 20;
constexpr std::chrono::minutes kMaxAgeOfStranger{10};
// Calls that may begin within a second before one is let in.
constexpr std::uint64_t kMaxCallsOfStranger = 64;

}  // namespace

void ConnectionAccount::OnReceived(std::uint64_t total, Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - std::max(seen_, accepted_)).count();
  const auto small_talk = static_cast<std::uint64_t>(seconds * kSmallTalk_bytes_s);
  if (small_talk > 0) seen_ = now;  // else what is less than a byte would be lost
  const std::uint64_t came = total - std::min(total, total_);
  const std::uint64_t replies = std::min(came, replies_);
  const std::uint64_t late = std::min(came - replies, late_);
  total_ += came;
  replies_ -= replies;
  late_ -= late;
  owed_ += came - replies - late;
  if (!reading_.empty()) unsure_ += late;
  owed_ -= std::min(owed_, small_talk);
  NoteLeast(now);
  if (owed() <= kFirstBytes) {
    owing_since_.reset();
  } else if (!owing_since_ && owed_ > kFirstBytes) {
    owing_since_ = now;
  }
}

void ConnectionAccount::OnMessage(std::size_t bytes, Clock::time_point now) {
  const auto with_overhead =
      static_cast<std::uint64_t>(static_cast<double>(bytes) * (1 + kOverheadShare));
  const std::uint64_t made = with_overhead + kOverheadOfCall;
  const std::uint64_t sure = std::min(owed_, made);
  owed_ -= sure;
  unsure_ -= std::min(unsure_, made - sure);
  least_ = std::min(least_, owed());
  if (owing_since_) owing_since_ = now;
}

void ConnectionAccount::OnSent(std::size_t bytes) {
  replies_ = std::min(replies_ + kReply + bytes / kBytesOfMessageByReply, kMaxReplies);
}

std::uint64_t ConnectionAccount::BeginReading() {
  return *reading_.insert(total_ - std::min(total_, kFirstBytes));
}

void ConnectionAccount::EndReading(std::uint64_t since) {
  const auto found = reading_.find(since);
  if (found != reading_.end()) reading_.erase(found);
  ForgetWhatNobodyHolds();
}

void ConnectionAccount::Forgive(std::uint64_t since) {
  if (!reading_.contains(since)) return;
  const std::uint64_t forgiven = std::min(owed_, total_ - since);
  owed_ -= forgiven;
  unsure_ += forgiven;
  late_ = std::min(late_ + kFirstBytes, kMaxLate);
  EndReading(since);
}

// Whoever reads holds nothing that came before it began to.
void ConnectionAccount::ForgetWhatNobodyHolds() {
  unsure_ = reading_.empty() ? 0 : std::min(unsure_, total_ - *reading_.begin());
  least_ = std::min(least_, owed());
}

void ConnectionAccount::OnBegunCalls(std::uint64_t total, std::uint64_t max_calls_s,
                                     Clock::time_point now) {
  // Nobody looked meanwhile: how many of them are of the last second is not known.
  if (now - calls_since_ > std::chrono::seconds{1}) {
    calls_since_ = now;
    calls_before_ = total;
  }
  calls_ = total;
  floods_ = calls_ - calls_before_ > (admitted_ ? max_calls_s : kMaxCallsOfStranger);
}

void ConnectionAccount::NoteLeast(Clock::time_point now) {
  if (now - second_ > std::chrono::seconds{1}) {
    second_ = now;
    least_before_ = std::exchange(least_, owed());
  }
  least_ = std::min(least_, owed());
}

ConnectionAccount::Clock::duration ConnectionAccount::Owing(Clock::time_point now) const {
  return owing_since_ ? now - *owing_since_ : Clock::duration::zero();
}

bool ConnectionAccount::IsFlooding() const {
  return floods_ || (!admitted_ && owed() > kMaxOwedByStranger);
}

std::optional<std::string> ConnectionAccount::Fault(const AccountLimits& limits,
                                                    Clock::time_point now) const {
  const auto bytes = [this] { return std::to_string(owed()) + " bytes that make no message"; };
  if (!admitted_ && owed() > kMaxOwedByStranger) return "sent " + bytes() + ", with no call let in";
  if (!admitted_ && now - accepted_ > kMaxAgeOfStranger) {
    return "had no call let in for 10 minutes";
  }
  if (floods_) {
    return "began " + std::to_string(calls_ - calls_before_) + " calls within a second";
  }
  if (owed() > limits.max_owed) return "sent " + bytes();
  if (Owing(now) > limits.max_transfer) {
    return "sent " + bytes() + " in " + std::to_string(limits.max_transfer.count()) + " s";
  }
  return std::nullopt;
}

}  // namespace fovea::server
