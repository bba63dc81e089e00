#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/status.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "server/rpc/unsent_answers.h"

namespace fovea::server {

// What limits of all calls have in common.
struct TransferRules {
  grpc::CompletionQueue* queue;
  std::chrono::seconds max_transfer;
  UnsentAnswers& unsent;
};

// Ends a call whose message does not come, or whose answer is not taken, in time: until then both
// cost memory.
class TransferLimit {
 public:
  TransferLimit(grpc::ServerContext* context, grpc::CompletionQueue* queue,
                std::chrono::seconds limit, UnsentAnswers& unsent)
      : context_(context), queue_(queue), limit_(limit), unsent_(unsent) {}
  TransferLimit(grpc::ServerContext* context, const TransferRules& rules)
      : TransferLimit(context, rules.queue, rules.max_transfer, rules.unsent) {}

  // A transfer begins, one at a time. `call` holds this, and is held until End() or the end of the
  // time, when `on_late` is called in place of the call being cancelled, which tells nothing but
  // that: not why, nor the request's id. It is called on the event loop's thread.
  void Begin(const std::shared_ptr<void>& call, std::function<void()> on_late = {});
  // An answer of so many bytes is sent. Before it is handed to gRPC, which may be done with it at
  // once.
  void BeginAnswer(const std::shared_ptr<void>& call, std::size_t bytes);
  // It has come to its end: the context is left alone from now on, though the time's end may be on
  // its way.
  void End();

  // Where it has cancelled the call: why.
  std::optional<grpc::Status> why_cancelled() const {
    const std::lock_guard lock(mutex_);
    return why_cancelled_;
  }

 private:
  std::uint64_t NextTransfer();
  void SetAlarm(const std::shared_ptr<void>& call, std::function<void()> on_late);
  bool EndLate(std::uint64_t transfer);
  void Cancel(std::uint64_t transfer, const grpc::Status& why);

  grpc::ServerContext* const context_;
  grpc::CompletionQueue* const queue_;
  const std::chrono::seconds limit_;
  UnsentAnswers& unsent_;
  mutable std::mutex mutex_;
  std::uint64_t transfer_ = 0;  // each has a number
  bool running_ = false;        // that one
  std::optional<grpc::Status> why_cancelled_;
  std::unique_ptr<grpc::Alarm> alarm_;
  UnsentAnswers::Token answer_;
};

}  // namespace fovea::server
