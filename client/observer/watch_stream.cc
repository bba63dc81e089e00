#include "client/observer/watch_stream.h"

#include <grpcpp/client_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/sync_stream.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "client/observer/ending_threads.h"
#include "client/read_bytes.h"
#include "fovea/v1/observation_service.grpc.pb.h"

namespace fovea::observer {
namespace {

LinkState StateOf(const grpc::Status& status) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNAUTHENTICATED:
    case grpc::StatusCode::PERMISSION_DENIED:
      return {LinkState::Kind::kRefused, status.error_message()};
    case grpc::StatusCode::UNIMPLEMENTED:
      return {LinkState::Kind::kRefused, "the server has no observers (--observers)"};
    case grpc::StatusCode::UNAVAILABLE:
      return {LinkState::Kind::kAway, "cannot be reached: " + status.error_message()};
    default:
      return {LinkState::Kind::kAway, status.error_message()};
  }
}

}  // namespace

// What the thread works with.
class WatchStream::Watching {
 public:
  Watching(ServerLink link, std::string token, v1::WatchRequest request, Listener listener)
      : link_(std::move(link)),
        token_(std::move(token)),
        request_(std::move(request)),
        listener_(std::move(listener)) {}

  void Run(const std::stop_token& stop);
  // Nobody listens from now on.
  void Leave();

  std::atomic<bool> has_ended = false;

 private:
  void Pause(const std::stop_token& stop, std::chrono::milliseconds wait);
  bool Watch(const std::stop_token& stop);  // whether anything came, all of which could be read
  template <typename Function, typename... Arguments>
  void Tell(const Function& function, Arguments&&... arguments);

  const ServerLink link_;
  const std::string token_;
  const v1::WatchRequest request_;
  const Listener listener_;
  std::mutex pause_mutex_;
  std::condition_variable_any pause_;
  std::mutex listener_mutex_;  // held while it is called
  bool is_left_ = false;
};

WatchStream::WatchStream(ServerLink link, std::string token, v1::WatchRequest request,
                         Listener listener)
    : watching_(std::make_shared<Watching>(std::move(link), std::move(token), std::move(request),
                                           std::move(listener))),
      thread_([watching = watching_](const std::stop_token& stop) { watching->Run(stop); }) {}

WatchStream::~WatchStream() {
  thread_.request_stop();
  watching_->Leave();
  LeaveToEnd(std::move(thread_), {watching_, &watching_->has_ended});
}

void WatchStream::Watching::Leave() {
  const std::lock_guard lock(listener_mutex_);
  is_left_ = true;
}

template <typename Function, typename... Arguments>
void WatchStream::Watching::Tell(const Function& function, Arguments&&... arguments) {
  const std::lock_guard lock(listener_mutex_);
  if (!is_left_) function(std::forward<Arguments>(arguments)...);
}

void WatchStream::Watching::Run(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kFirst{100}, kLongest{2000};
  std::chrono::milliseconds wait = kFirst;
  while (!stop.stop_requested()) {
    wait = Watch(stop) ? kFirst : std::min(2 * wait, kLongest);
    Pause(stop, wait);
  }
  has_ended = true;
}

// Ends with the connection, where there is none: gRPC tries to connect only while it is asked to.
void WatchStream::Watching::Pause(const std::stop_token& stop, std::chrono::milliseconds wait) {
  constexpr std::chrono::milliseconds kLook{200};  // a wait of gRPC does not end with `stop`
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + wait;
  const bool is_connected = link_.channel->GetState(false) == GRPC_CHANNEL_READY;
  while (!is_connected && !stop.stop_requested() && Clock::now() < end) {
    if (link_.channel->WaitForConnected(std::chrono::system_clock::now() + kLook)) return;
  }
  std::unique_lock lock(pause_mutex_);
  pause_.wait_until(lock, stop, end, [] { return false; });
}

bool WatchStream::Watching::Watch(const std::stop_token& stop) {
  using grpc::internal::RpcMethod;
  const RpcMethod method("/fovea.v1.ObservationService/Watch", RpcMethod::SERVER_STREAMING);
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer " + token_);
  const std::stop_callback cancel(stop, [&] { context.TryCancel(); });
  const std::unique_ptr<grpc::ClientReader<grpc::ByteBuffer>> reader(
      grpc::internal::ClientReaderFactory<grpc::ByteBuffer>::Create(link_.channel.get(), method,
                                                                    &context, request_));
  bool came = false;
  std::optional<grpc::Status> unread;
  for (grpc::ByteBuffer bytes; !unread && reader->Read(&bytes);) {
    v1::WatchResponse response;
    if (!client::ParseBytes(&bytes, &response)) {
      unread = client::EndUnread<v1::WatchResponse>(reader.get(), &context);
    } else if (response.has_observer()) {
      came = true;
      link_.outage->OnBack(link_.address);
      Tell(listener_.on_observer, response.observer());
      Tell(listener_.on_state, LinkState{LinkState::Kind::kWatching, ""});
    } else if (response.has_frame()) {
      Tell(listener_.on_frame, std::move(response));
    }
  }
  const grpc::Status status = unread ? *unread : reader->Finish();
  if (unread || status.error_code() == grpc::StatusCode::UNAVAILABLE) {
    link_.outage->OnAway(link_.address, status.error_message());
  }
  LinkState state = StateOf(status);
  if (state.kind == LinkState::Kind::kRefused) link_.outage->OnBack(link_.address);
  // It ends the call of whoever has other rights now, too: the next answer says which.
  if (came && state.kind == LinkState::Kind::kRefused) state.kind = LinkState::Kind::kConnecting;
  if (!stop.stop_requested()) Tell(listener_.on_state, state);
  return came && !unread;  // who sends such a message again is not asked all the time
}

}  // namespace fovea::observer
