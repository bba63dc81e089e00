#include "client/resuming_stream.h"

#include <algorithm>
#include <string>
#include <utility>

#include "client/better_server.h"
#include "client/retry.h"
#include "client/rpc_error.h"
#include "client/servers.h"

namespace fovea::client {

ResumingStream::ResumingStream(std::shared_ptr<Servers> servers, ClientOptions options,
                               std::chrono::milliseconds timeout, CallOptions call)
    : servers_(std::move(servers)),
      options_(std::move(options)),
      call_(std::move(call)),
      deadline_(Clock::now() + timeout),
      better_server_(std::make_unique<BetterServer>(*servers_, options_)) {
  std::string problem;
  server_ = servers_->Home(std::min(deadline_, Clock::now() + options_.timeout), &problem);
  if (!server_) {
    throw RpcError({grpc::StatusCode::UNAVAILABLE, problem}, std::nullopt, call_.request_id);
  }
  stream_ = Open();
}

ResumingStream::~ResumingStream() = default;

bool ResumingStream::Send(const v1::DetectStreamRequest& request) {
  std::shared_ptr<DetectStream> current;
  std::optional<v1::DetectOptions> options;
  bool accept_picks = false;
  {
    const std::lock_guard lock(mutex_);
    if (num_sent_++ == 0) accept_picks_ = request.accept_picks();
    if (request.has_options()) last_options_ = request.options();
    if (std::exchange(is_new_, false)) {
      if (!request.has_options()) options = last_options_;
      accept_picks = accept_picks_;
    }
    current = stream_;
  }
  // Not under the lock: where the server takes nothing in, this waits, and Cancel() has to end it.
  if (!options && !accept_picks) return current->Send(request);
  v1::DetectStreamRequest first = request;
  if (options) *first.mutable_options() = std::move(*options);
  if (accept_picks) first.set_accept_picks(true);
  return current->Send(first);
}

void ResumingStream::DoneSending() {
  const std::lock_guard lock(mutex_);
  done_ = true;
  stream_->DoneSending();
}

void ResumingStream::Cancel() {
  const std::lock_guard lock(mutex_);
  canceled_ = true;
  stream_->Cancel();
  changed_.notify_all();
}

std::optional<ResumingStream::Answer> ResumingStream::Receive() {
  MoveIfBetter();
  while (true) {
    const std::shared_ptr<DetectStream> current = stream();
    std::optional<v1::DetectStreamResponse> response;
    try {
      response = current->Receive();
    } catch (const RpcError& error) {
      broken_by_ = error;
      Resume(*current);
      continue;
    }
    if (response) return Account(std::move(*response));
    if (num_lost_ > 0) throw *broken_by_;  // no answer is left that could say so
    return std::nullopt;
  }
}

std::shared_ptr<DetectStream> ResumingStream::stream() const {
  const std::lock_guard lock(mutex_);
  return stream_;
}

ResumingStream::Answer ResumingStream::Account(v1::DetectStreamResponse response) {
  if (std::exchange(failures_, 0) > 0) servers_->OnAnswered(server_);
  // first_of_stream_ changes in this thread only.
  response.set_sequence(response.sequence() + first_of_stream_);
  next_expected_ = response.sequence() + 1;
  return {std::move(response), std::exchange(num_lost_, 0)};
}

void ResumingStream::MoveIfBetter() {
  std::shared_ptr<Server> better = better_server_->Find(server_);
  if (!better) return;
  const std::lock_guard lock(mutex_);
  if (done_ || canceled_) return;  // what is under way is to be answered
  broken_by_.emplace(
      grpc::Status(grpc::StatusCode::UNAVAILABLE, "the stream went to another server"));
  servers_->Move(better);
  stream_->Cancel();
  GoOn(std::move(better));
}

void ResumingStream::GoOn(std::shared_ptr<Server> server) {
  server_ = std::move(server);
  num_lost_ += num_sent_ - next_expected_;
  next_expected_ = first_of_stream_ = num_sent_;
  stream_ = Open();
  is_new_ = true;
  if (done_) stream_->DoneSending();
}

void ResumingStream::Resume(const DetectStream& broken) {
  if (failures_++ == 0) broken_since_ = Clock::now();
  // A stream that Cancel() ended says nothing of its server.
  const bool is_worth_it = !canceled_ && IsWorthRetrying(*broken.status(), broken.context());
  if (is_worth_it) ReportEnd(broken);
  // Also where another server is there: robots that lost the same one should not all come at once.
  const bool elsewhere = is_worth_it && !servers_->AreAllAway();
  const auto wait = BackoffAfter(elsewhere ? 1 : failures_, options_.retry,
                                 elsewhere ? std::nullopt : RetryAfter(broken.context()));
  const Clock::time_point now = Clock::now();
  const bool too_late = now + wait >= deadline_ || now - broken_since_ >= options_.timeout;
  if (too_late || !is_worth_it || options_.retry.max_attempts <= 1) throw;

  const std::shared_ptr<Server> next = AwaitConnection();
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, wait, [this] { return canceled_.load(); })) throw;
  if (Clock::now() >= deadline_) throw;  // a stream without time would not say what is wrong
  GoOn(next ? next : server_);
}

void ResumingStream::ReportEnd(const DetectStream& broken) {
  const auto retry_after = RetryAfter(broken.context());
  if (retry_after && retry_after->count() == 0) {  // of age
    servers_->OnDisconnected(server_);
  } else {
    servers_->OnAway(server_, retry_after);
  }
}

// Streams that fail at once, with pauses between them, would not let the channel connect: see
// Pause(). A stream that waits for the connection would, but holds up Send() and knows no patience.
std::shared_ptr<Server> ResumingStream::AwaitConnection() {
  constexpr std::chrono::milliseconds kLook{20};  // gRPC's wait cannot be ended by Cancel()
  const Clock::time_point end = std::min(deadline_, broken_since_ + options_.timeout);
  std::string problem;
  while (!canceled_ && Clock::now() < end) {
    std::shared_ptr<Server> server = servers_->Home(Clock::now() + kLook, &problem);
    if (!server) continue;
    // A refusal is waited for where there is nobody else.
    if (IsConnected(*server)) return server;
    servers_->OnAway(server);
  }
  return nullptr;
}

// Waits as long as it comes about, but no longer than others that may be there are worth.
bool ResumingStream::IsConnected(const Server& server) const {
  constexpr std::chrono::milliseconds kLook{20};
  const auto longest = servers_->size() > 1 ? std::chrono::seconds(1) : options_.timeout;
  const Clock::time_point end = std::min(deadline_, Clock::now() + longest);
  do {
    if (server.channel->WaitForConnected(std::chrono::system_clock::now() + kLook)) return true;
  } while (!canceled_ && Clock::now() < end &&
           server.channel->GetState(true) != GRPC_CHANNEL_TRANSIENT_FAILURE);
  return false;
}

std::shared_ptr<DetectStream> ResumingStream::Open() {
  return std::make_shared<DetectStream>(
      *server_->channel, options_,
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()), call_);
}

}  // namespace fovea::client
