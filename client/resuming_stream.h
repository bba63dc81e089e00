#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "client/client_options.h"
#include "client/detect_stream.h"
#include "client/rpc_error.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::client {

class BetterServer;
class Servers;
struct Server;

// A DetectStream that is opened again when it breaks: at another server at once where the client
// has several, else when the server is back; Client::OpenResumingStream makes it. Where its server
// has more to do than it can, and another one would answer it much more often, it goes there. A
// server that has had the stream for long enough ends it between two answers (its
// --max-connection-age-s); the stream then goes on at any of them. Options hold on, and so does
// what the first request says of picks. One thread may send while another receives.
class ResumingStream {
 public:
  struct Answer {
    // Its `sequence` counts on over all connections, so it is the number of the frame sent.
    v1::DetectStreamResponse response;
    // Frames since the last answer that were sent into a connection that broke or was left, and get
    // no answer.
    std::uint64_t lost = 0;
  };

  ResumingStream(std::shared_ptr<Servers> servers, ClientOptions options,
                 std::chrono::milliseconds timeout, CallOptions call = {});

  ~ResumingStream();

  // False where the connection is broken: the frame is lost.
  bool Send(const v1::DetectStreamRequest& request);
  // As that of a DetectStream.
  void DoneSending();

  // Ends the stream at once, connected or not; Receive() then throws. From any thread.
  void Cancel();

  // The next answer. Empty at the end, after DoneSending(). Throws RpcError where trying again
  // would bring nothing or RetryOptions::max_attempts is 1, where no frame has been answered for
  // ClientOptions::timeout since the stream broke, where its time is over, and where the last
  // frames are among the lost: then at the end, and it says what broke the stream.
  std::optional<Answer> Receive();

 private:
  using Clock = std::chrono::steady_clock;

  std::shared_ptr<DetectStream> stream() const;
  Answer Account(v1::DetectStreamResponse response);
  // To a server with less to do, if there is one.
  void MoveIfBetter();
  // Opens the stream there; what was sent and not answered is lost. mutex_ is held.
  void GoOn(std::shared_ptr<Server> server);
  // Waits and opens a new stream; rethrows the error where that is not worth it.
  void Resume(const DetectStream& broken);
  void ReportEnd(const DetectStream& broken);
  // A server that there is a connection to. Null where the patience or the stream's time ends, or
  // Cancel() was called.
  std::shared_ptr<Server> AwaitConnection();
  bool IsConnected(const Server& server) const;
  std::shared_ptr<DetectStream> Open();

  const std::shared_ptr<Servers> servers_;
  const ClientOptions options_;
  const CallOptions call_;  // of each connection
  const Clock::time_point deadline_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;  // canceled_
  std::shared_ptr<Server> server_;   // the stream's; null = none was found
  std::shared_ptr<DetectStream> stream_;
  v1::DetectOptions last_options_;
  bool accept_picks_ = false;  // as the first request said
  bool is_new_ = false;        // the stream does not know these yet
  bool done_ = false;
  std::atomic<bool> canceled_ = false;  // set under mutex_
  std::uint64_t num_sent_ = 0, first_of_stream_ = 0;

  // Only of the receiving thread.
  std::unique_ptr<BetterServer> better_server_;
  std::uint64_t next_expected_ = 0;  // number of the first frame whose fate is not known
  std::uint64_t num_lost_ = 0;
  std::optional<RpcError> broken_by_;  // last; there where frames are lost
  int failures_ = 0;
  Clock::time_point broken_since_;
};

}  // namespace fovea::client
