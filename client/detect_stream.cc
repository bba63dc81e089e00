#include "client/detect_stream.h"

#include <utility>

#include "client/channel.h"
#include "client/read_bytes.h"
#include "client/retry.h"

namespace fovea::client {

DetectStream::DetectStream(grpc::Channel& channel, const ClientOptions& options,
                           std::chrono::milliseconds timeout, CallOptions call)
    : call_(std::move(call)), max_answer_mib_(options.max_answer_mib) {
  using Factory =
      grpc::internal::ClientReaderWriterFactory<v1::DetectStreamRequest, grpc::ByteBuffer>;
  using grpc::internal::RpcMethod;
  const RpcMethod method("/fovea.v1.DetectionService/DetectStream", RpcMethod::BIDI_STREAMING);
  PrepareCall(options, timeout, &context_, call_);
  stream_.reset(Factory::Create(&channel, method, &context_));
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
  grpc::ByteBuffer bytes;
  if (!finished_ && stream_->Read(&bytes)) {
    v1::DetectStreamResponse response;
    if (ParseBytes(&bytes, &response)) return response;
    finished_ = EndUnread<v1::DetectStreamResponse>(stream_.get(), &context_);
  }
  if (!finished_) finished_ = stream_->Finish();
  if (!finished_->ok()) throw ErrorOf(*finished_, context_, call_, max_answer_mib_);
  return std::nullopt;
}

}  // namespace fovea::client
