#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/async_stream.h>
#include <grpcpp/support/byte_buffer.h>

#include <memory>
#include <mutex>
#include <optional>

#include "server/rpc/caller.h"
#include "server/rpc/observation_service.h"
#include "server/rpc/transfer_limit.h"

namespace fovea::server {

// One call of Watch: sends what is in its mailbox, one message at a time.
class WatchCall : public std::enable_shared_from_this<WatchCall> {
 public:
  // Waits for a call, and for the next one when that came.
  static void Accept(const ObservationEnvironment& environment);

  explicit WatchCall(const ObservationEnvironment& environment);
  ~WatchCall();

 private:
  void OnRequest();
  void Open();
  void Greet(const ObserverEntry& observer);
  void Check();  // whether the observer may still watch
  void End(const grpc::Status& status);
  void Write(const grpc::ByteBuffer& bytes);
  void OnWritten(bool ok);
  void Proceed();  // mutex_ is held

  const ObservationEnvironment& environment_;
  const LiveCalls::Token token_;
  LiveCalls::Token begun_;
  grpc::ServerContext context_;
  Caller caller_;
  TransferLimit transfer_;
  grpc::ByteBuffer bytes_;  // the request
  grpc::ServerAsyncWriter<grpc::ByteBuffer> stream_{&context_};
  std::shared_ptr<WatchHub::Watcher> watcher_;

  std::mutex mutex_;
  bool busy_ = false;                   // writes
  std::optional<grpc::Status> status_;  // to end with
  bool finished_ = false;
};

}  // namespace fovea::server
