#include "client/detect_stream.h"

#include <utility>

#include "client/channel.h"
#include "client/retry.h"

namespace fovea::client {

DetectStream::DetectStream(v1::DetectionService::Stub& stub, const ClientOptions& options,
                           std::chrono::milliseconds timeout, CallOptions call)
    : call_(std::move(call)) {
  PrepareCall(options, timeout, &context_, call_);
  stream_ = stub.DetectStream(&context_);
}

DetectStream::~DetectStream() {
  if (finished_) return;
  context_.TryCancel();
  stream_->Finish();
}

bool DetectStream::Send(const v1::DetectStreamRequest& request) { return stream_->Write(request); }

void DetectStream::DoneSending() {
  if (!std::exchange(done_, true)) stream_->WritesDone();  // gRPC ends the program at a second one
}

void DetectStream::Cancel() { context_.TryCancel(); }

std::optional<v1::DetectStreamResponse> DetectStream::Receive() {
  v1::DetectStreamResponse response;
  if (!finished_ && stream_->Read(&response)) return response;
  if (!finished_) finished_ = stream_->Finish();
  if (!finished_->ok()) throw ErrorOf(*finished_, context_, call_);
  return std::nullopt;
}

}  // namespace fovea::client
