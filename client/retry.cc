#include "client/retry.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <random>

#include "client/channel.h"
#include "client/rpc_error.h"

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

// What the server says in the trailing metadata, of a call that has ended.
std::optional<milliseconds> RetryAfter(const grpc::ClientContext& context) {
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto found = metadata.find("retry-after-ms");
  if (found == metadata.end()) return std::nullopt;
  const char* end = found->second.data() + found->second.size();
  int value = 0;
  if (std::from_chars(found->second.data(), end, value).ptr != end) return std::nullopt;
  return milliseconds(value);
}

double RandomShare() {
  thread_local std::minstd_rand random(std::random_device{}());
  return std::uniform_real_distribution(0.5, 1.0)(random);
}

}  // namespace

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
                          const grpc::ClientContext& context) {
  const int doublings = std::min(attempt - 1, 16);
  const auto wait = std::min<std::chrono::duration<double, std::milli>>(
      options.backoff * (1 << doublings), options.max_backoff);
  const auto random_wait = std::chrono::duration_cast<milliseconds>(wait * RandomShare());
  return std::max(random_wait, RetryAfter(context).value_or(milliseconds(0)));
}

void CallWithRetries(grpc::Channel& channel, const ClientOptions& options, milliseconds timeout,
                     const std::function<grpc::Status(grpc::ClientContext*)>& call) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + timeout;
  for (int attempt = 1;; ++attempt) {
    grpc::ClientContext context;
    PrepareCall(options, std::chrono::duration_cast<milliseconds>(deadline - Clock::now()),
                &context);
    const grpc::Status status = call(&context);
    if (status.ok()) return;
    const milliseconds wait = BackoffAfter(attempt, options.retry, context);
    if (attempt >= options.retry.max_attempts || !IsWorthRetrying(status, context) ||
        Clock::now() + wait >= deadline) {
      throw RpcError(status, RetryAfter(context));
    }
    Pause(channel, wait);
  }
}

}  // namespace fovea::client
