#include "server/rpc/detect_call.h"

#include "server/status.h"

namespace fovea::server {

void DetectCall::Accept(const CallEnvironment& environment) {
  const auto call = std::make_shared<DetectCall>(environment);
  environment.service.RequestDetect(&call->context_, &call->request_, &call->responder_,
                                    environment.queue, environment.queue,
                                    Then([call, &environment](bool ok) {
                                      if (!ok) return;  // the server stops
                                      Accept(environment);
                                      call->OnRequest();
                                    }));
}

DetectCall::DetectCall(const CallEnvironment& environment)
    : environment_(environment), token_(environment.live_calls.Enter()) {}

void DetectCall::OnRequest() {
  received_ = std::chrono::steady_clock::now();
  const auto self = shared_from_this();
  caller_.Begin([self] { self->OnGone(); });
  begun_ = environment_.live_calls.Begin([] {});
  if (!begun_) {
    Refuse(StatusOfStopping());
    return;
  }
  try {
    caller_.Identify(environment_.gate_keeper);
    environment_.metrics.OnReceived(caller_.robot(), request_.ByteSizeLong());
    ticket_ = environment_.scheduler.Submit(
        caller_.robot(), {.compute =
                              [self] {
                                self->status_ = self->environment_.answerer.Answer(
                                    self->Request(), self->caller_,
                                    self->response_.mutable_detections());
                              },
                          .deliver = [self] { self->Deliver(); }});
  } catch (const Overloaded& full) {
    AddRetryAfter(full.retry_after, &context_);
    Refuse(StatusOfCurrentException(/*deadline_passed=*/false));
  } catch (...) {
    Refuse(StatusOfCurrentException(/*deadline_passed=*/false));
  }
}

void DetectCall::Deliver() {
  environment_.metrics.OnSent(response_.ByteSizeLong());
  responder_.Finish(response_, status_, Then([self = shared_from_this()](bool) {}));
}

// Work that has begun stops by itself.
void DetectCall::OnGone() {
  if (!environment_.scheduler.Withdraw(caller_.robot(), ticket_)) return;
  Refuse(caller_.StatusOfGone());
}

void DetectCall::Refuse(const grpc::Status& status) {
  environment_.answerer.Refuse(Request(), caller_, status);
  responder_.FinishWithError(status, Then([self = shared_from_this()](bool) {}));
}

FrameRequest DetectCall::Request() const {
  return {.frame = request_.has_frame() ? &request_.frame() : nullptr,
          .options = &request_.options(),
          .received = received_};
}

}  // namespace fovea::server
