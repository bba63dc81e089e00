// What a client does when its server is busy, gone or back.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>

#include "client/client.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/support/held_address.h"

namespace fovea::client {
namespace {

using testing::FindOne;
using testing::HeldAddress;
using testing::kPatience;
using testing::LoopbackOptions;

ClientOptions RetryingLong() {
  ClientOptions options{.timeout = kPatience};
  options.retry = {.max_attempts = 1000,
                   .backoff = std::chrono::milliseconds(1),
                   .max_backoff = std::chrono::milliseconds(20)};
  return options;
}

server::ServerOptions At(const HeldAddress& address) {
  server::ServerOptions options = LoopbackOptions();
  options.listen = {address.Text()};
  return options;
}

v1::DetectStreamRequest StreamFrame(const std::string& id) {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  request.mutable_frame()->set_id(id);
  return request;
}

// A server with room for one frame, which waits at its gate.
struct BusyServer {
  BusyServer() { gate.WaitUntilBegun(); }

  static server::ServerOptions Options() {
    server::ServerOptions options = LoopbackOptions();
    options.compute_threads = 1;
    options.max_waiting = 0;
    return options;
  }

  double NumRefused() const {
    return testing::MetricValue(*loopback.server.metrics(), "fovea_frames_answered_total",
                                "RESOURCE_EXHAUSTED");
  }

  testing::Gate gate;
  const testing::Loopback loopback{std::ref(gate), Options()};
  std::jthread first{[this] { loopback.client.Detect(testing::TestRequest()); }};
};

TEST(Retry, ComesBackWhenABusyServerSaysWhen) {
  BusyServer busy;
  std::jthread second([&] {
    EXPECT_NO_THROW(
        Client(busy.loopback.server.Address(), RetryingLong()).Detect(testing::TestRequest()));
  });
  while (busy.NumRefused() == 0) std::this_thread::yield();
  busy.gate.Let(2);
}

TEST(Retry, ComesBackUntilTheDeadlineWhereItIsToldWhen) {
  BusyServer busy;
  std::atomic<bool> ended = false;
  std::jthread second([&] {
    const Client client(busy.loopback.server.Address(), {.timeout = kPatience});
    EXPECT_NO_THROW(client.Detect(testing::TestRequest()));
    ended = true;
  });
  while (!ended && busy.NumRefused() < 7) std::this_thread::yield();
  busy.gate.Let(2);
}

TEST(Retry, FindsAServerThatIsBack) {
  const HeldAddress address;
  std::optional<server::Server> server(std::in_place, At(address), FindOne);
  const Client client(address.Text(), RetryingLong());
  EXPECT_NO_THROW(client.Detect(testing::TestRequest()));
  server.reset();
  std::jthread late([&] { server.emplace(At(address), FindOne); });
  EXPECT_NO_THROW(client.Detect(testing::TestRequest()));
}

TEST(Retry, DoesNotRepeatWhatIsWrong) {
  const testing::Loopback loopback(FindOne);
  const Client client(loopback.server.Address(), RetryingLong());
  EXPECT_THROW(client.Detect({}), RpcError);
  EXPECT_EQ(testing::MetricValue(*loopback.server.metrics(), "fovea_frames_received_total"), 1);
}

TEST(ResumingStream, OutlivesItsServerAndCountsWhatWasLost) {
  const HeldAddress address;
  std::optional<server::Server> server(std::in_place, At(address), FindOne);
  const Client client(address.Text(), RetryingLong());
  const auto stream = client.OpenResumingStream(kPatience);
  v1::DetectStreamRequest first = StreamFrame("0");
  first.mutable_options()->set_return_masks(true);
  stream->Send(first);
  EXPECT_EQ(stream->Receive()->response.sequence(), 0U);

  server.reset();
  std::atomic<std::uint64_t> num_sent = 1;
  while (stream->Send(StreamFrame(std::to_string(num_sent++)))) std::this_thread::yield();
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(stream->Send(StreamFrame(std::to_string(num_sent++)))) << "the server is away";
  }
  server.emplace(At(address), FindOne);
  // Sends until one comes through; each frame is answered, dropped or lost.
  std::atomic<bool> answered = false;
  std::jthread sender([&] {
    while (!answered) {
      stream->Send(StreamFrame(std::to_string(num_sent++)));
      std::this_thread::yield();
    }
    stream->DoneSending();
  });
  std::uint64_t num_answered = 1, num_dropped = 0, num_lost = 0, last = 0;
  while (const auto answer = stream->Receive()) {
    answered = true;
    EXPECT_EQ(answer->response.frame_id(), std::to_string(answer->response.sequence()));
    EXPECT_TRUE(answer->response.detections().objects(0).has_mask());  // the options hold
    ++num_answered;
    num_dropped += answer->response.dropped();
    num_lost += answer->lost;
    last = answer->response.sequence();
  }
  sender.join();
  EXPECT_GE(num_lost, 3U);
  EXPECT_EQ(last, num_sent - 1);
  EXPECT_EQ(num_answered + num_dropped + num_lost, num_sent);
}

TEST(ResumingStream, GivesUpInTheEnd) {
  const HeldAddress nobody;
  ClientOptions options = RetryingLong();
  options.timeout = std::chrono::milliseconds(200);
  const auto stream = Client(nobody.Text(), options).OpenResumingStream(kPatience);
  EXPECT_EQ(testing::StatusOf([&] { stream->Receive(); }).error_code(),
            grpc::StatusCode::UNAVAILABLE);
}

TEST(ResumingStream, SaysWhatBrokeItWhenItsTimeIsOver) {
  const HeldAddress nobody;
  const auto stream =
      Client(nobody.Text(), RetryingLong()).OpenResumingStream(std::chrono::seconds(1));
  const grpc::Status status = testing::StatusOf([&] { stream->Receive(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_THAT(status.error_message(), ::testing::HasSubstr("onnect"));
}

// Takes streams and never reads what comes.
class Deaf final : public v1::DetectionService::Service {
  using Stream = grpc::ServerReaderWriter<v1::DetectStreamResponse, v1::DetectStreamRequest>;
  grpc::Status DetectStream(grpc::ServerContext* context, Stream* /*stream*/) override {
    while (!context->IsCancelled()) std::this_thread::yield();
    return grpc::Status::CANCELLED;
  }
};

TEST(ResumingStream, IsCancelledWhileItCannotSend) {
  Deaf deaf;
  grpc::ServerBuilder builder;
  int port = 0;
  builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
  builder.RegisterService(&deaf);
  const auto server = builder.BuildAndStart();
  const Client client("127.0.0.1:" + std::to_string(port), RetryingLong());
  const auto stream = client.OpenResumingStream(kPatience);
  std::atomic<bool> sending = false;
  std::jthread sender([&] {
    // More than any window of flow control.
    v1::DetectStreamRequest request;
    request.mutable_frame()->mutable_color()->set_data(std::string(100 << 20, 'x'));
    sending = true;
    stream->Send(request);
  });
  while (!sending) std::this_thread::yield();
  std::jthread receiver([&] {  // of a deadline it would say DEADLINE_EXCEEDED
    EXPECT_EQ(testing::StatusOf([&] { stream->Receive(); }).error_code(),
              grpc::StatusCode::CANCELLED);
  });
  stream->Cancel();
}

}  // namespace
}  // namespace fovea::client
