#include "server/rpc/caller.h"

#include <chrono>
#include <utility>

#include "server/log_exception.h"
#include "server/rpc/call_names.h"
#include "server/status.h"

namespace fovea::server {

Caller::Caller(grpc::ServerContext* context, ConnectionTable& connections,
               const LiveCalls& live_calls)
    : context_(context), connections_(connections), live_calls_(live_calls), account_(connections) {
  context_->AsyncNotifyWhenDone(&done_);
}

void Caller::Begin(std::function<void()> on_gone) {
  done_.then = [this, on_gone = std::move(on_gone)](bool) {
    if (!context_->IsCancelled()) return;
    gone_ = true;
    Guard(on_gone);
  };
}

bool Caller::IsConnected() const { return connections_.IsOpen(context_->peer()); }

void Caller::Identify(const GateKeeper& gate_keeper) {
  NameRequest();  // for the log, which tells who is turned away
  Take(gate_keeper.Admit(*context_));
}

void Caller::Identify(Admission admission) {
  NameRequest();
  Take(std::move(admission));
}

void Caller::NameRequest() {
  request_id_ = RequestId(context_->client_metadata());
  context_->AddTrailingMetadata(kRequestIdKey, request_id_);
}

void Caller::Take(Admission admission) {
  admission_ = std::move(admission);
  trace_ = TraceOf(context_->client_metadata());
  comes_only_if_room_ = context_->client_metadata().contains(kOnlyIfRoomKey);
  account_.Admit(context_->peer());
}

void Caller::End() noexcept {
  LogCurrentException("a call ends");
  context_->TryCancel();
}

bool Caller::DeadlinePassed() const {
  return std::chrono::system_clock::now() >= context_->deadline();
}

grpc::Status Caller::StatusOfGone() const {
  const bool deadline_passed = DeadlinePassed();
  if (!deadline_passed && live_calls_.given_up()) return StatusOfGivenUp();
  return StatusOfGoneCaller(deadline_passed);
}

}  // namespace fovea::server
