// Who called, and whether anybody still waits for the answer.
#pragma once

#include <grpcpp/server_context.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "server/access/gate_keeper.h"
#include "server/connections/call_account.h"
#include "server/connections/connection_table.h"
#include "server/rpc/event_loop.h"
#include "server/rpc/live_calls.h"
#include "server/scheduling/robot_id.h"
#include "server/tracing/trace_context.h"

namespace fovea::server {

class Caller {
 public:
  // Before the call is asked for: gRPC wants to know by then that it shall tell of its end.
  Caller(grpc::ServerContext* context, ConnectionTable& connections, const LiveCalls& live_calls);

  // The call has begun. `on_gone` is called on the event loop's thread if the caller leaves or its
  // deadline passes before the answer; it is kept until the call's end and no longer.
  void Begin(std::function<void()> on_gone);

  // Whether the connection is still open: who makes calls only to reset them leaves thousands that
  // are not worth a look once it is not.
  bool IsConnected() const;

  // Finds out the following four. Throws Unauthenticated where the caller may not call, and
  // std::invalid_argument where the names that it chose will not do.
  void Identify(const GateKeeper& gate_keeper);
  // The same of a caller that others let in.
  void Identify(Admission admission);
  // Throws Unauthenticated where the caller may not call any more. Not from several threads at
  // once.
  void Recheck(const GateKeeper& gate_keeper) { gate_keeper.Readmit(*context_, &admission_); }
  const std::string& robot() const { return admission_.robot.name; }
  // Whose turn the call takes.
  const RobotId& id() const { return admission_.robot; }
  const std::string& request_id() const { return request_id_; }
  // "ipv4:10.0.0.7:1234".
  std::string peer() const { return context_->peer(); }
  // Of the caller, where it sends one.
  const std::optional<TraceContext>& trace() const { return trace_; }
  // Whether it only asks for room here, and will not come back by what it is told.
  bool comes_only_if_room() const { return comes_only_if_room_; }

  // A message of this call has come, and it reads on; or it does not. Both keep account of what the
  // connection has sent.
  void OnMessage(std::size_t bytes) { account_.OnMessage(bytes); }
  void OnLastMessage(std::size_t bytes) { account_.OnLastMessage(bytes); }
  // It was sent an answer, one of many for its message.
  void OnSent(std::size_t bytes) { account_.OnSent(bytes); }

  // A step of the call. Whatever it throws ends this call, of which the caller learns by CANCELLED,
  // and nothing else.
  template <typename Step>
  void Guard(Step&& step) noexcept {
    try {
      step();
    } catch (...) {
      End();
    }
  }

  // Whether to give up. From any thread.
  bool IsGone() const { return gone_ || DeadlinePassed(); }
  bool DeadlinePassed() const;

  // CANCELLED or DEADLINE_EXCEEDED; UNAVAILABLE where the server has given up its calls.
  grpc::Status StatusOfGone() const;

 private:
  void NameRequest();
  void Take(Admission admission);
  void End() noexcept;

  grpc::ServerContext* const context_;
  std::atomic<bool> gone_ = false;
  CallEvent done_;
  Admission admission_;
  std::string request_id_;
  std::optional<TraceContext> trace_;
  bool comes_only_if_room_ = false;
  ConnectionTable& connections_;
  const LiveCalls& live_calls_;
  CallAccount account_;
};

}  // namespace fovea::server
