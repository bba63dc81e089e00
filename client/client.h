// Talks to a fovea server. Needs gRPC and protobuf only.
#pragma once

#include <grpcpp/channel.h>

#include <chrono>
#include <memory>
#include <string>

#include "client/client_options.h"
#include "client/detect_stream.h"
#include "client/resuming_stream.h"
#include "client/rpc_error.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::client {

// Thread-safe: one client serves any number of threads over one connection, which it opens at the
// first call and opens again when it was lost. Every call has a deadline; it throws RpcError with
// DEADLINE_EXCEEDED when that passes and with UNAVAILABLE when the server is away, after the
// attempts of ClientOptions::retry.
class Client {
 public:
  // `address` is HOST:PORT or any gRPC target, for example "ipv4:10.0.0.1:50051,10.0.0.2:50051".
  // Calls go to several addresses in turn.
  explicit Client(const std::string& address, ClientOptions options = {});

  // Returns once the server says that it serves; throws RpcError after `timeout`.
  void WaitUntilReady(std::chrono::milliseconds timeout) const;

  // Asks once. False where the server answers that it does not serve; throws RpcError where it
  // does not answer.
  bool IsServing() const;

  v1::GetServerInfoResponse GetServerInfo() const;
  v1::GetStatisticsResponse GetStatistics() const;
  v1::ListOptionsResponse ListOptions() const;

  v1::DetectResponse Detect(const v1::DetectRequest& request) const;
  v1::DetectResponse Detect(const v1::DetectRequest& request,
                            std::chrono::milliseconds timeout) const;

  // `timeout` is for the whole stream.
  std::unique_ptr<DetectStream> OpenStream(std::chrono::milliseconds timeout) const;
  // The same, but a stream that outlives the server: see ResumingStream.
  std::unique_ptr<ResumingStream> OpenResumingStream(std::chrono::milliseconds timeout) const;

 private:
  const ClientOptions options_;
  const std::shared_ptr<grpc::Channel> channel_;
  const std::shared_ptr<v1::DetectionService::Stub> stub_;
};

}  // namespace fovea::client
