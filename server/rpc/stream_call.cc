#include "server/rpc/stream_call.h"

#include <random>
#include <utility>

#include "server/error_details.h"
#include "server/rpc/option_bytes.h"
#include "server/rpc/stream_answer.h"
#include "server/rpc/untaken_answer.h"
#include "server/status.h"
#include "server/until_it_works.h"
#include "server/watching/request_log.h"

namespace fovea::server {
namespace {

template <typename Message>
grpc::ByteBuffer BytesOf(const Message& message) {
  grpc::ByteBuffer bytes;
  bool own_buffer = false;
  grpc::SerializationTraits<Message>::Serialize(message, &bytes, &own_buffer);
  return bytes;
}

}  // namespace

void StreamCall::Accept(const CallEnvironment& environment) {
  const auto call = std::make_shared<StreamCall>(environment);
  environment.service.RequestDetectStream(&call->context_, &call->stream_, environment.queue,
                                          environment.queue, Then([call, &environment](bool ok) {
                                            if (!ok) return;  // the server stops
                                            UntilItWorks([&] { Accept(environment); });
                                            call->caller_.Guard([&] { call->OnRequest(); });
                                          }));
}

StreamCall::StreamCall(const CallEnvironment& environment)
    : environment_(environment),
      token_(environment.live_calls.Enter()),
      caller_(&context_, environment.connections, environment.live_calls),
      transfer_(&context_, environment.queue, environment.max_transfer, environment.unsent),
      newest_(environment.frame_room) {}

StreamCall::~StreamCall() {
  if (place_) environment_.metrics.OnStreams(-1);
}

void StreamCall::OnRequest() {
  caller_.Begin([self = shared_from_this()] { self->OnGone(); });
  const std::lock_guard lock(mutex_);
  if (!caller_.IsConnected()) {
    Finish(caller_.StatusOfGone());
    return;
  }
  try {
    Open();
  } catch (const Overloaded& full) {
    AddRetryAfter(full.retry_after, &context_);
    Refuse(StatusOfCurrentException(), full.reason);
  } catch (...) {
    const grpc::Status status = StatusOfCurrentException();
    Refuse(status, NameOf(status.error_code()));
  }
}

void StreamCall::Refuse(const grpc::Status& status, const char* reason) {
  LogRefusedStream(caller_.request_id(), caller_.robot(), caller_.peer(), status);
  environment_.metrics.OnRefused(caller_.robot(), reason);
  Finish(status);
}

void StreamCall::Open() {
  caller_.Identify(environment_.gate_keeper);
  begun_ = environment_.live_calls.Begin(
      [weak = weak_from_this()] {
        if (const auto self = weak.lock()) self->End();
      },
      [weak = weak_from_this()] {
        if (const auto self = weak.lock()) self->Check();
      });
  if (!begun_) {
    const grpc::Status stopping = StatusOfStopping();
    Refuse(stopping, NameOf(stopping.error_code()));
    return;
  }
  place_ = environment_.stream_places.Take(caller_.id());
  environment_.metrics.OnStreams(1);
  LimitAge();
  Read();
}

// gRPC ends connections by their age too, but streams in the middle of a frame.
void StreamCall::LimitAge() {
  if (environment_.max_stream_age.count() == 0) return;
  // Streams that began together do not end together.
  thread_local std::minstd_rand random(std::random_device{}());
  const auto age = environment_.max_stream_age * std::uniform_real_distribution(0.9, 1.1)(random);
  const auto end = std::chrono::system_clock::now() +
                   std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
  age_.Set(environment_.queue, end, Then([self = shared_from_this()](bool ok) {
             self->caller_.Guard([&] {
               const std::lock_guard lock(self->mutex_);
               self->is_old_ = ok;
               if (ok) self->Proceed();
             });
           }));
}

void StreamCall::Read() {
  stream_.Read(&bytes_, Then([self = shared_from_this()](bool ok) {
    self->caller_.Guard([&] { ok ? self->OnRead() : self->OnNoMore(); });
  }));
}

void StreamCall::OnNoMore() {
  const std::lock_guard lock(mutex_);
  no_more_ = true;
  Proceed();
}

void StreamCall::OnRead() {
  caller_.OnMessage(bytes_.Length());
  const std::lock_guard lock(mutex_);
  if (finished_) return;
  environment_.metrics.OnReceived(caller_.robot());
  environment_.metrics.OnReceivedBytes(bytes_.Length());
  if (newest_.num_received() == 0 && environment_.picks != nullptr && AcceptsPicks(bytes_)) {
    listening_ = environment_.picks->Listen(caller_.robot());
  }
  if (newest_.Put(caller_.id().group, &bytes_)) environment_.metrics.OnDropped();
  CheckAccess();
  Proceed();
  if (!finished_) Read();
}

void StreamCall::OnGone() {
  const std::lock_guard lock(mutex_);
  // Work that has begun stops by itself.
  if (busy_ && environment_.scheduler.Withdraw(caller_.id(), ticket_)) busy_ = false;
  Proceed();
}

void StreamCall::OnWritten(bool ok) {
  if (pick_ && ok) pick_->OnSent();
  pick_.reset();
  const std::lock_guard lock(mutex_);
  busy_ = false;
  broken_ = !ok;
  if (broken_) NoteUntakenAnswer(transfer_, caller_, environment_.metrics);
  Proceed();
}

void StreamCall::End() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  Proceed();
}

void StreamCall::Check() {
  const std::lock_guard lock(mutex_);
  CheckAccess();
  if (barred_) Proceed();
}

void StreamCall::CheckAccess() {
  if (finished_ || barred_) return;
  try {
    caller_.Recheck(environment_.gate_keeper);
    return;
  } catch (...) {
    barred_ = StatusOfCurrentException();
  }
  // A frame that is looked at is answered, one that waits is not.
  if (busy_ && environment_.scheduler.Withdraw(caller_.id(), ticket_)) busy_ = false;
}

void StreamCall::Proceed() {
  if (finished_ || busy_) return;
  if (broken_ || caller_.IsGone()) {
    Finish(StatusOfGone());
  } else if (ending_) {
    Finish(StatusOfStopping());
  } else if (barred_) {
    Refuse(*barred_, NameOf(barred_->error_code()));
  } else if (is_old_ && !no_more_) {
    AddRetryAfter(std::chrono::milliseconds(0), &context_);
    Finish(StatusOfGreatAge());
  } else if (newest_.waits()) {
    TakeTurn();
  } else if (no_more_) {
    Finish(grpc::Status::OK);
  }
}

grpc::Status StreamCall::StatusOfGone() const {
  if (const auto cancelled = transfer_.why_cancelled()) return *cancelled;
  return caller_.StatusOfGone();
}

void StreamCall::TakeTurn() {
  const auto self = shared_from_this();
  ticket_ = environment_.scheduler.SubmitTurn(
      caller_.id(), {.compute = [self] { self->ComputeOrSayWhyNot(); },
                     .deliver = [self] { self->caller_.Guard([&] { self->DeliverOrEnd(); }); },
                     .displaced = {}});
  busy_ = true;  // not where there was no memory for it, which ends the call
}

// An answer for which there was no memory leaves nothing behind that waits for its end.
void StreamCall::DeliverOrEnd() {
  try {
    Deliver();
  } catch (...) {
    transfer_.End();
    OnWritten(false);
    throw;
  }
}

void StreamCall::Deliver() {
  if (listening_) pick_ = environment_.picks->Take(caller_.robot());
  if (pick_) *response_.mutable_pick() = pick_->pick();
  // There was no memory even to say so.
  if (response_.outcome_case() == v1::DetectStreamResponse::OUTCOME_NOT_SET) {
    SetError({grpc::StatusCode::INTERNAL, "internal error; the server's log says more"},
             &response_);
  }
  if (response_.has_error()) response_.mutable_error()->set_request_id(caller_.request_id());
  const grpc::ByteBuffer bytes = BytesOf(response_);
  response_ = {};
  environment_.metrics.OnSent(bytes.Length());
  transfer_.BeginAnswer(shared_from_this(), bytes.Length());
  stream_.Write(bytes, Then([self = shared_from_this()](bool ok) {
                  self->transfer_.End();
                  self->caller_.Guard([&] { self->OnWritten(ok); });
                }));
}

void StreamCall::ComputeOrSayWhyNot() {
  const auto began = std::chrono::steady_clock::now();
  response_.Clear();
  ReceivedFrame received;
  {
    const std::lock_guard lock(mutex_);
    received = newest_.Take();
  }
  response_.set_dropped(received.num_dropped);
  response_.set_sequence(received.sequence);
  grpc::Status status;
  try {
    status = Compute(received, began);
  } catch (...) {  // there may be no memory for the message itself
    response_.clear_outcome();
    status = StatusOfCurrentException();
    environment_.answerer.Refuse({.received = received.at, .began = began}, caller_, status);
  }
  if (status.ok()) return;
  response_.clear_outcome();
  SetError(status, &response_);
}

grpc::Status StreamCall::Compute(ReceivedFrame& received,
                                 std::chrono::steady_clock::time_point began) {
  v1::DetectStreamRequest request;
  grpc::Status status = received.room ? options_.Parse(&received, &request) : StatusOfNoRoom();
  received.bytes.Clear();
  received.room.reset();
  response_.set_frame_id(request.frame().id());
  options_.Complete(received, &request);
  const FrameRequest frame{.frame = request.has_frame() ? &request.frame() : nullptr,
                           .options = &request.options(),
                           .received = received.at,
                           .began = began,
                           .tracker = &tracker_};
  if (status.ok()) {
    status = environment_.answerer.Answer(frame, caller_, response_.mutable_detections());
  } else {
    environment_.answerer.Refuse(frame, caller_, status);
  }
  return status;
}

void StreamCall::Finish(const grpc::Status& status) {
  finished_ = true;
  // Of a frame that waits, this is all that the caller hears.
  if (newest_.waits()) {
    environment_.answerer.Refuse({.received = newest_.Take().at}, caller_, status);
  }
  listening_.reset();
  age_.Cancel();
  stream_.Finish(status, Then([self = shared_from_this()](bool) {}));
}

}  // namespace fovea::server
