#include "client/resuming_stream.h"

#include <algorithm>
#include <utility>

#include "client/retry.h"
#include "client/rpc_error.h"

namespace fovea::client {

ResumingStream::ResumingStream(std::shared_ptr<grpc::Channel> channel,
                               std::shared_ptr<v1::DetectionService::Stub> stub,
                               ClientOptions options, std::chrono::milliseconds timeout)
    : channel_(std::move(channel)),
      stub_(std::move(stub)),
      options_(std::move(options)),
      deadline_(Clock::now() + timeout),
      stream_(Open()) {}

void ResumingStream::Send(const v1::DetectStreamRequest& request) {
  std::shared_ptr<DetectStream> current;
  std::optional<v1::DetectOptions> options;
  {
    const std::lock_guard lock(mutex_);
    ++num_sent_;
    if (request.has_options()) last_options_ = request.options();
    if (std::exchange(repeat_options_, false) && !request.has_options()) options = last_options_;
    current = stream_;
  }
  // Not under the lock: where the server takes nothing in, this waits, and Cancel() has to end it.
  if (!options) {
    current->Send(request);
    return;
  }
  v1::DetectStreamRequest with_options = request;
  *with_options.mutable_options() = std::move(*options);
  current->Send(with_options);
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
  while (true) {
    const std::shared_ptr<DetectStream> current = stream();
    try {
      auto response = current->Receive();
      if (!response) return std::nullopt;
      return Account(std::move(*response));
    } catch (const RpcError&) {
      Resume(*current);
    }
  }
}

std::shared_ptr<DetectStream> ResumingStream::stream() const {
  const std::lock_guard lock(mutex_);
  return stream_;
}

ResumingStream::Answer ResumingStream::Account(v1::DetectStreamResponse response) {
  failures_ = 0;
  // first_of_stream_ changes in this thread only.
  response.set_sequence(response.sequence() + first_of_stream_);
  next_expected_ = response.sequence() + 1;
  return {std::move(response), std::exchange(num_lost_, 0)};
}

void ResumingStream::Resume(const DetectStream& broken) {
  if (failures_++ == 0) broken_since_ = Clock::now();
  const auto wait = BackoffAfter(failures_, options_.retry, broken.context());
  const Clock::time_point now = Clock::now();
  const bool too_late = now + wait >= deadline_ || now - broken_since_ >= options_.timeout;
  if (too_late || !IsWorthRetrying(*broken.status(), broken.context())) throw;

  AwaitConnection();
  // Also then: robots that lost the same server should not all come at once, and a server that is
  // there may have refused the stream.
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, wait, [this] { return canceled_.load(); })) throw;
  num_lost_ += num_sent_ - next_expected_;
  next_expected_ = first_of_stream_ = num_sent_;
  stream_ = Open();
  repeat_options_ = true;
  if (done_) stream_->DoneSending();
}

// Streams that fail at once, with pauses between them, would not let the channel connect: see
// Pause(). A stream that waits for the connection would, but holds up Send() and knows no patience.
void ResumingStream::AwaitConnection() const {
  constexpr std::chrono::milliseconds kLook{20};  // gRPC's wait cannot be ended by Cancel()
  const Clock::time_point end = std::min(deadline_, broken_since_ + options_.timeout);
  while (!canceled_ && Clock::now() < end) {
    if (channel_->WaitForConnected(std::chrono::system_clock::now() + kLook)) return;
  }
}

std::shared_ptr<DetectStream> ResumingStream::Open() {
  return std::make_shared<DetectStream>(
      *stub_, options_,
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()));
}

}  // namespace fovea::client
