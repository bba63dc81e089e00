#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/async_stream.h>

#include <functional>
#include <memory>

#include "server/rpc/caller.h"
#include "server/rpc/detection_service.h"
#include "server/rpc/transfer_limit.h"

namespace fovea::server {

// One call of Detect. Lives as long as an operation or its turn refers to it.
class DetectCall : public std::enable_shared_from_this<DetectCall> {
 public:
  // Waits for a call, and for the next one when that came.
  static void Accept(const CallEnvironment& environment);

  explicit DetectCall(const CallEnvironment& environment);

 private:
  // `step`, where the call may go on; else the call is refused.
  void Proceed(const std::function<void()>& step);
  void OnCall();
  void OnLate();
  void OnRead(bool ok);
  void TakeTurn();
  void ComputeOrSayWhyNot();
  void Compute();
  void Deliver();
  void OnGone();
  // `reason` is what it is counted as; null: the status code.
  void Refuse(const grpc::Status& status, const char* reason = nullptr);
  FrameRequest Request() const;

  const CallEnvironment& environment_;
  const LiveCalls::Token token_;
  LiveCalls::Token begun_;
  grpc::ServerContext context_;
  Caller caller_;
  TransferLimit transfer_;
  grpc::ServerAsyncReader<v1::DetectResponse, grpc::ByteBuffer> stream_{&context_};
  bool is_late_ = false;      // the message is
  Scheduler::Upload upload_;  // until it is there
  grpc::ByteBuffer bytes_;    // the message, until it is parsed
  v1::DetectRequest request_;
  v1::DetectResponse response_;
  // Until something is found of the frame.
  grpc::Status status_{grpc::StatusCode::INTERNAL, "internal error; the server's log says more"};
  std::chrono::steady_clock::time_point received_, began_;
  Scheduler::Ticket ticket_ = 0;
};

}  // namespace fovea::server
