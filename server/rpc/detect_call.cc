#include "server/rpc/detect_call.h"

#include <utility>

#include "server/error_details.h"
#include "server/rpc/parse.h"
#include "server/rpc/untaken_answer.h"
#include "server/status.h"
#include "server/until_it_works.h"

namespace fovea::server {
namespace {

using Clock = std::chrono::steady_clock;

// Where a message did not come whole. gRPC does not tell a caller that left from a message that it
// has refused itself.
grpc::Status StatusOfHalfMessage(const grpc::Status& gone) {
  if (gone.error_code() != grpc::StatusCode::CANCELLED) return gone;
  return {grpc::StatusCode::CANCELLED,
          "the caller left before its message was whole, or it is larger than --max-message-mib"};
}

}  // namespace

void DetectCall::Accept(const CallEnvironment& environment) {
  const auto call = std::make_shared<DetectCall>(environment);
  environment.service.RequestDetect(&call->context_, &call->stream_, environment.queue,
                                    Then([call, &environment](bool ok) {
                                      if (!ok) return;  // the server stops
                                      UntilItWorks([&] { Accept(environment); });
                                      call->caller_.Guard([&] { call->OnCall(); });
                                    }));
}

DetectCall::DetectCall(const CallEnvironment& environment)
    : environment_(environment),
      token_(environment.live_calls.Enter()),
      caller_(&context_, environment.connections, environment.live_calls),
      transfer_(&context_, environment.queue, environment.max_transfer, environment.unsent) {}

void DetectCall::Proceed(const std::function<void()>& step) {
  try {
    step();
  } catch (const Overloaded& full) {
    AddRetryAfter(full.retry_after, &context_);
    Refuse(StatusOfCurrentException(), full.reason);
  } catch (...) {  // whatever it is, the caller gets a status
    Refuse(StatusOfCurrentException());
  }
}

void DetectCall::OnCall() {
  received_ = Clock::now();
  caller_.Begin([self = shared_from_this()] { self->OnGone(); });
  if (!caller_.IsConnected()) {
    stream_.FinishWithError(caller_.StatusOfGone(), Then([self = shared_from_this()](bool) {}));
    return;
  }
  begun_ = environment_.live_calls.Begin([] {});
  if (!begun_) {
    Refuse(StatusOfStopping());
    return;
  }
  Proceed([this] {
    caller_.Identify(environment_.gate_keeper);
    environment_.metrics.OnReceived(caller_.robot());
    // Else a frame comes whole before it is refused, which takes time of both sides.
    upload_ = environment_.scheduler.Enter(caller_.id(), caller_.comes_only_if_room()
                                                             ? Scheduler::IfFull::kForget
                                                             : Scheduler::IfFull::kKeepPlace);
    transfer_.Begin(shared_from_this(), [this] { caller_.Guard([this] { OnLate(); }); });
    stream_.Read(&bytes_, Then([self = shared_from_this()](bool ok) {
      self->caller_.Guard([&] { self->OnRead(ok); });
    }));
  });
}

// The message has not come in time, and does not any more: the reading ends with the call.
void DetectCall::OnLate() {
  is_late_ = true;
  received_ = Clock::now();
  upload_.reset();
  transfer_.BeginAnswer(shared_from_this(), 0);
  Refuse(StatusOfSlowness());
}

void DetectCall::OnRead(bool ok) {
  if (is_late_) return;
  received_ = Clock::now();
  upload_.reset();
  transfer_.End();
  if (!ok) {
    Refuse(StatusOfHalfMessage(caller_.StatusOfGone()));
    return;
  }
  caller_.OnLastMessage(bytes_.Length());
  environment_.metrics.OnReceivedBytes(bytes_.Length());
  Proceed([this] { TakeTurn(); });
}

void DetectCall::TakeTurn() {
  const auto self = shared_from_this();
  ticket_ = environment_.scheduler.Submit(
      caller_.id(), {.compute = [self] { self->ComputeOrSayWhyNot(); },
                     .deliver = [self] { self->caller_.Guard([&] { self->Deliver(); }); },
                     .displaced =
                         [self](const Overloaded& why) {
                           self->caller_.Guard([&] { self->Proceed([&] { throw why; }); });
                         }});
}

// There may be no memory for the message itself, of which half may have been read.
void DetectCall::ComputeOrSayWhyNot() {
  began_ = Clock::now();
  try {
    Compute();
  } catch (...) {
    status_ = StatusOfCurrentException();
    request_.Clear();
    environment_.answerer.Refuse(Request(), caller_, status_);
  }
  bytes_.Clear();
}

void DetectCall::Compute() {
  grpc::Status status = Parse(&bytes_, &request_);
  bytes_.Clear();
  if (status.ok()) {
    status = environment_.answerer.Answer(Request(), caller_, response_.mutable_detections());
  } else {
    environment_.answerer.Refuse(Request(), caller_, status);
  }
  status_ = std::move(status);
}

void DetectCall::Deliver() {
  const std::size_t size = response_.ByteSizeLong();
  environment_.metrics.OnSent(size);
  if (const auto wait = RetryAfterOf(status_)) AddRetryAfter(*wait, &context_);
  transfer_.BeginAnswer(shared_from_this(), size);
  stream_.Finish(response_, status_, Then([self = shared_from_this()](bool) {
                   self->transfer_.End();
                   NoteUntakenAnswer(self->transfer_, self->caller_, self->environment_.metrics);
                 }));
  response_ = {};  // gRPC has it in bytes
}

// Work that has begun stops by itself.
void DetectCall::OnGone() {
  if (!environment_.scheduler.Withdraw(caller_.id(), ticket_)) return;
  Refuse(caller_.StatusOfGone());
}

void DetectCall::Refuse(const grpc::Status& status, const char* reason) {
  environment_.answerer.Refuse(Request(), caller_, status);
  environment_.metrics.OnRefused(caller_.robot(),
                                 reason != nullptr ? reason : NameOf(status.error_code()));
  const bool full = status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED;
  stream_.FinishWithError(
      status, Then([self = shared_from_this(), full](bool) {
        self->transfer_.End();
        if (full) self->environment_.metrics.OnTurnedAway(Clock::now() - self->received_);
      }));
}

FrameRequest DetectCall::Request() const {
  return {.frame = request_.has_frame() ? &request_.frame() : nullptr,
          .options = &request_.options(),
          .received = received_,
          .began = began_};
}

}  // namespace fovea::server
