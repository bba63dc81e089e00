#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/sync_stream.h>

#include <chrono>
#include <memory>
#include <optional>

#include "client/client_options.h"
#include "client/rpc_error.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::client {

// One stream of frames; Client::OpenStream makes it. One thread may send while another receives.
// Send as fast as frames come: the server answers the newest one and drops those in between;
// DetectStreamResponse.dropped counts them. With accept_picks in the first request, people may mark
// objects for this robot, and answers bring the newest mark (DetectStreamResponse.pick).
class DetectStream {
 public:
  DetectStream(grpc::Channel& channel, const ClientOptions& options,
               std::chrono::milliseconds timeout, CallOptions call = {});
  // Cancels what has no answer yet.
  ~DetectStream();

  DetectStream(const DetectStream&) = delete;
  DetectStream& operator=(const DetectStream&) = delete;

  // False once the stream is broken; Receive() then throws the reason.
  bool Send(const v1::DetectStreamRequest& request);

  // No more frames will come; answers to those sent still do. Does nothing the second time.
  void DoneSending();

  // Ends the stream at once. From any thread.
  void Cancel();

  // Once Receive() has ended or thrown.
  const std::optional<grpc::Status>& status() const { return finished_; }
  const grpc::ClientContext& context() const { return context_; }

  // The next answer in order, which may be a FrameError. Empty at the end, after DoneSending().
  // Throws RpcError where the stream broke or ran out of time, INTERNAL where an answer could not
  // be read.
  std::optional<v1::DetectStreamResponse> Receive();

 private:
  const CallOptions call_;
  const int max_answer_mib_;
  grpc::ClientContext context_;
  std::unique_ptr<grpc::ClientReaderWriter<v1::DetectStreamRequest, grpc::ByteBuffer>> stream_;
  bool done_ = false;  // of the sending thread
  std::optional<grpc::Status> finished_;
};

}  // namespace fovea::client
