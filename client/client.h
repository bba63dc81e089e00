// Talks to a fovea server. Needs gRPC and protobuf only.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "client/client_options.h"
#include "client/detect_stream.h"
#include "client/resuming_stream.h"
#include "client/rpc_error.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::client {

class Servers;

// Thread-safe: one client serves any number of threads over one connection, which it opens at the
// first call and opens again when it was lost. Every call has a deadline; it throws RpcError with
// DEADLINE_EXCEEDED when that passes and with UNAVAILABLE when the server is away, after the
// attempts of ClientOptions::retry. Timeouts of more than 1e9 s, 31 years, count as that.
class Client {
 public:
  // `address` is HOST:PORT (IPv6 in brackets), unix:/PATH, or several of these with commas between
  // them; else std::invalid_argument is thrown. A name stands for all addresses that it has, and is
  // looked up again when something fails.
  //
  // Of several servers a client stays with one, chosen by chance, over one connection. It asks the
  // others as soon as that refuses or is away, and goes to another one where that takes its calls
  // or promises to be free much sooner. Where its connection ends it chooses anew.
  explicit Client(const std::string& address, ClientOptions options = {});

  // Returns once the server says that it serves; throws RpcError after `timeout`.
  void WaitUntilReady(std::chrono::milliseconds timeout) const;

  // Asks once. False where the server answers that it does not serve; throws RpcError where it
  // does not answer.
  bool IsServing() const;

  v1::GetServerInfoResponse GetServerInfo() const;
  v1::GetStatisticsResponse GetStatistics() const;
  v1::ListOptionsResponse ListOptions() const;

  // `call` throws std::invalid_argument where it is not as CallOptions says. Without tracking,
  // which needs a stream (OpenStream, OpenResumingStream).
  v1::DetectResponse Detect(const v1::DetectRequest& request, const CallOptions& call = {}) const;
  v1::DetectResponse Detect(const v1::DetectRequest& request, std::chrono::milliseconds timeout,
                            const CallOptions& call = {}) const;

  // `timeout` is for the whole stream.
  std::unique_ptr<DetectStream> OpenStream(std::chrono::milliseconds timeout,
                                           const CallOptions& call = {}) const;
  // The same, but a stream that outlives the server: see ResumingStream.
  std::unique_ptr<ResumingStream> OpenResumingStream(std::chrono::milliseconds timeout,
                                                     const CallOptions& call = {}) const;

 private:
  const ClientOptions options_;
  const std::shared_ptr<Servers> servers_;
};

}  // namespace fovea::client
