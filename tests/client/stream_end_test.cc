// How streams end, and what a stream that broke says then.
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "client/client.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::client {
namespace {

using testing::kPatience;

// Takes frames to their end without an answer; breaks the first stream then, and ends the others.
class BreaksOnce final : public v1::DetectionService::Service {
 public:
  BreaksOnce() {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    server_ = builder.BuildAndStart();
  }

  ~BreaksOnce() override { server_->Shutdown(); }

  Client MakeClient(int max_attempts) const {
    ClientOptions options{.timeout = kPatience};
    options.retry = {.max_attempts = max_attempts,
                     .backoff = std::chrono::milliseconds(1),
                     .max_backoff = std::chrono::milliseconds(1)};
    return Client("127.0.0.1:" + std::to_string(port_), options);
  }
  int num_streams() const { return num_streams_; }

 private:
  using Stream = grpc::ServerReaderWriter<v1::DetectStreamResponse, v1::DetectStreamRequest>;
  grpc::Status DetectStream(grpc::ServerContext* /*context*/, Stream* stream) override {
    v1::DetectStreamRequest request;
    while (stream->Read(&request)) continue;
    if (num_streams_++ > 0) return grpc::Status::OK;
    return {grpc::StatusCode::UNAVAILABLE, "it broke"};
  }

  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
  std::atomic<int> num_streams_ = 0;
};

TEST(StreamEnd, SaysThatTheLastFramesAreLost) {
  const BreaksOnce server;
  const auto stream = server.MakeClient(/*max_attempts=*/5).OpenResumingStream(kPatience);
  stream->Send({});
  stream->DoneSending();
  for (int time = 0; time < 2; ++time) {  // and goes on saying so
    const grpc::Status status = testing::StatusOf([&] { stream->Receive(); });
    EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
    EXPECT_EQ(status.error_message(), "it broke");
  }
}

TEST(StreamEnd, IsAnEndWhereNothingIsLost) {
  const BreaksOnce server;
  const auto stream = server.MakeClient(/*max_attempts=*/5).OpenResumingStream(kPatience);
  stream->DoneSending();
  EXPECT_FALSE(stream->Receive());
  EXPECT_EQ(server.num_streams(), 2);
}

TEST(StreamEnd, IsTheBreakWhereThereIsOneAttempt) {
  const BreaksOnce server;
  const auto stream = server.MakeClient(/*max_attempts=*/1).OpenResumingStream(kPatience);
  stream->DoneSending();
  EXPECT_EQ(testing::StatusOf([&] { stream->Receive(); }).error_message(), "it broke");
  EXPECT_EQ(server.num_streams(), 1);
}

template <typename Stream>
void EndTwice(Stream& stream) {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  stream.Send(request);
  stream.DoneSending();
  stream.DoneSending();
  EXPECT_TRUE(stream.Receive());
  EXPECT_FALSE(stream.Receive());
}

TEST(StreamEnd, MayBeSaidTwice) {
  const testing::Loopback loopback(testing::FindOne);
  EndTwice(*loopback.client.OpenStream(kPatience));
  EndTwice(*loopback.client.OpenResumingStream(kPatience));
}

// Answers the first frame with what is no message, and leaves the call open.
class AnswersNonsense final
    : public v1::DetectionService::WithRawMethod_DetectStream<v1::DetectionService::Service> {
 public:
  AnswersNonsense() {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    queue_ = builder.AddCompletionQueue();
    server_ = builder.BuildAndStart();
    RequestDetectStream(&context_, &stream_, queue_.get(), queue_.get(), nullptr);
    thread_ = std::jthread([this] { Run(); });
  }

  ~AnswersNonsense() override {
    server_->Shutdown(std::chrono::system_clock::now());
    queue_->Shutdown();
  }

  Client MakeClient() const {
    return Client("127.0.0.1:" + std::to_string(port_), testing::PatientOptions());
  }

 private:
  void Run() {
    void* tag = nullptr;
    bool ok = false;
    if (!queue_->Next(&tag, &ok) || !ok) return;
    const grpc::Slice slice("\xFF\xFF");
    stream_.Write(grpc::ByteBuffer(&slice, 1), nullptr);
    while (queue_->Next(&tag, &ok)) continue;
  }

  int port_ = 0;
  grpc::ServerContext context_;
  grpc::ServerAsyncReaderWriter<grpc::ByteBuffer, grpc::ByteBuffer> stream_{&context_};
  std::unique_ptr<grpc::ServerCompletionQueue> queue_;
  std::unique_ptr<grpc::Server> server_;
  std::jthread thread_;
};

TEST(StreamEnd, IsSaidOfAnAnswerThatCannotBeRead) {
  const AnswersNonsense server;
  const auto stream = server.MakeClient().OpenStream(kPatience);
  const grpc::Status status = testing::StatusOf([&] { stream->Receive(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INTERNAL);
  EXPECT_EQ(status.error_message(), "the server sent a DetectStreamResponse that cannot be read");
}

}  // namespace
}  // namespace fovea::client
