#include "client/retry.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <random>
#include <stop_token>
#include <thread>

#include "client/channel.h"
#include "client/too_large.h"

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

double RandomShare() {
  thread_local std::minstd_rand random(std::random_device{}());
  return std::uniform_real_distribution(0.5, 1.0)(random);
}

// One way around the servers.
struct Attempt {
  bool answered = false, is_worth_another = true;
  std::optional<RpcError> error;
  std::optional<milliseconds> retry_after;  // of the server that refused and has a place in line
  std::shared_ptr<grpc::Channel> channel;   // of whom to ask next; null = no server was found
};

class AttemptMaker {
 public:
  using Call = std::function<grpc::Status(v1::DetectionService::Stub&, grpc::ClientContext*)>;

  AttemptMaker(Servers& servers, const ClientOptions& options, const CallOptions& call_options,
               Servers::Clock::time_point deadline, const Call& call)
      : servers_(servers),
        options_(options),
        call_options_(call_options),
        deadline_(deadline),
        call_(call) {}

  Attempt Make(bool asks_others) const {
    Attempt attempt;
    Servers::Round round(servers_, asks_others, deadline_);
    while (const auto ask = round.Next()) {
      Make(*ask, round, &attempt);
      if (attempt.answered || !attempt.is_worth_another) return attempt;
    }
    attempt.retry_after = round.wait();
    if (round.home()) attempt.channel = round.home()->channel;
    if (!attempt.error) {  // nobody to ask
      attempt.error.emplace(grpc::Status(grpc::StatusCode::UNAVAILABLE, round.problem()),
                            std::nullopt, call_options_.request_id);
    }
    return attempt;
  }

 private:
  void Make(const Servers::Round::Ask& ask, Servers::Round& round, Attempt* attempt) const {
    grpc::ClientContext context;
    PrepareCall(options_,
                std::chrono::duration_cast<milliseconds>(deadline_ - Servers::Clock::now()),
                &context, call_options_);
    if (ask.only_if_room) context.AddMetadata("fovea-only-if-room", "1");
    const std::stop_callback cancel(call_options_.stop, [&context] { context.TryCancel(); });
    const grpc::Status status = call_(*ask.server->stub, &context);
    if (status.ok()) {
      attempt->answered = true;
      round.OnAnswered();
      return;
    }
    const auto retry_after = RetryAfter(context);
    attempt->is_worth_another =
        IsWorthRetrying(status, context) && !call_options_.stop.stop_requested();
    const bool refused = status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED;
    if (attempt->is_worth_another && refused) {
      round.OnRefused(*retry_after);
    } else if (attempt->is_worth_another ||
               status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED) {
      round.OnAway();  // the next call is made to another one
    }
    // The last one's is of whom the client waits for.
    attempt->error = ErrorOf(status, context, call_options_, options_.max_answer_mib);
  }

  Servers& servers_;
  const ClientOptions& options_;
  const CallOptions& call_options_;
  const Servers::Clock::time_point deadline_;
  const Call& call_;
};

}  // namespace

std::optional<milliseconds> RetryAfter(const grpc::ClientContext& context) {
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto found = metadata.find("retry-after-ms");
  if (found == metadata.end()) return std::nullopt;
  const char* end = found->second.data() + found->second.size();
  int value = 0;
  if (std::from_chars(found->second.data(), end, value).ptr != end) return std::nullopt;
  return milliseconds(value);
}

RpcError ErrorOf(const grpc::Status& status, const grpc::ClientContext& context,
                 const CallOptions& call, int max_answer_mib) {
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto found = metadata.find("fovea-request-id");
  return RpcError(SayingWhatIsTooLarge(status, max_answer_mib), RetryAfter(context),
                  found == metadata.end()
                      ? call.request_id
                      : std::string(found->second.data(), found->second.size()));
}

bool IsWorthRetrying(const grpc::Status& status, const grpc::ClientContext& context) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
    case grpc::StatusCode::CANCELLED:  // not by us: by a server that stops
      return true;
    case grpc::StatusCode::RESOURCE_EXHAUSTED:  // else too large
      return RetryAfter(context).has_value();
    default:
      return false;
  }
}

milliseconds BackoffAfter(int attempt, const RetryOptions& options,
                          std::optional<milliseconds> retry_after) {
  if (retry_after && retry_after->count() > 0) return *retry_after;
  const int doublings = std::min(attempt - 1, 16);
  const auto wait = std::min<std::chrono::duration<double, std::milli>>(
      options.backoff * (1 << doublings), options.max_backoff);
  return std::chrono::duration_cast<milliseconds>(wait * RandomShare());
}

void CallWithRetries(Servers& servers, const ClientOptions& options, milliseconds timeout,
                     const AttemptMaker::Call& call, const CallOptions& call_options) {
  using Clock = Servers::Clock;
  const Clock::time_point deadline = Clock::now() + timeout;
  const AttemptMaker maker(servers, options, call_options, deadline, call);
  for (int number = 1;; ++number) {
    const Attempt attempt = maker.Make(/*asks_others=*/number == 1);
    if (attempt.answered) return;
    const milliseconds wait = BackoffAfter(number, options.retry, attempt.retry_after);
    // Who is told when to come back has no end but the deadline.
    const bool is_told = attempt.retry_after && options.retry.max_attempts > 1;
    const bool is_last = number >= options.retry.max_attempts && !is_told;
    if (is_last || !attempt.is_worth_another || Clock::now() + wait >= deadline) {
      throw *attempt.error;
    }
    if (attempt.channel) {
      Pause(*attempt.channel, wait);
    } else {
      std::this_thread::sleep_for(wait);
    }
  }
}

}  // namespace fovea::client
