#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>

#include "server/rpc/unsent_answers.h"

namespace fovea::server {

// Ends a call whose message does not come, or whose answer is not taken, in time: until then both
// cost memory.
class TransferLimit {
 public:
  TransferLimit(grpc::ServerContext* context, grpc::ServerCompletionQueue* queue,
                std::chrono::seconds limit, UnsentAnswers& unsent)
      : context_(context), queue_(queue), limit_(limit), unsent_(unsent) {}

  // A transfer begins. `call` holds this, and is held until End() or the end of the time.
  void Begin(const std::shared_ptr<void>& call);
  // An answer of so many bytes is sent. Before it is handed to gRPC, which may be done with it at
  // once.
  void BeginAnswer(const std::shared_ptr<void>& call, std::size_t bytes);
  // It has come to its end.
  void End() {
    alarm_.reset();
    answer_.reset();
  }

  // Whether the time has passed, and the call was cancelled.
  bool passed() const { return passed_; }

 private:
  grpc::ServerContext* const context_;
  grpc::ServerCompletionQueue* const queue_;
  const std::chrono::seconds limit_;
  UnsentAnswers& unsent_;
  std::atomic<bool> passed_ = false;
  std::unique_ptr<grpc::Alarm> alarm_;
  UnsentAnswers::Token answer_;
};

}  // namespace fovea::server
