// What a client does with several servers.
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "client/client.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::client {
namespace {

using testing::FindOne;
using testing::kPatience;
using testing::LoopbackOptions;

ClientOptions Persistent() {
  ClientOptions options{.timeout = kPatience};
  options.retry = {.max_attempts = 1000,
                   .backoff = std::chrono::milliseconds(1),
                   .max_backoff = std::chrono::milliseconds(20)};
  return options;
}

server::ServerOptions OneThread() {
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  options.max_waiting = 0;
  return options;
}

double FramesOf(const server::Server& server) {
  return testing::MetricValue(*server.metrics(), "fovea_received_bytes_total");
}

struct TwoServers {
  explicit TwoServers(const server::ServerOptions& options = LoopbackOptions())
      : a(std::in_place, options, FindOne), b(std::in_place, options, FindOne) {}

  std::string address() const { return a->Address() + "," + b->Address(); }

  std::optional<server::Server> a, b;
};

v1::DetectStreamRequest StreamFrame() {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  return request;
}

TEST(Fleet, AClientStaysWithOneServer) {
  const TwoServers two;
  const Client client(two.address(), Persistent());
  client.WaitUntilReady(kPatience);
  EXPECT_TRUE(client.IsServing());
  for (int call = 0; call < 10; ++call) client.Detect(testing::TestRequest());
  EXPECT_TRUE(FramesOf(*two.a) == 0 || FramesOf(*two.b) == 0);
}

TEST(Fleet, AClientStaysWithOneServerWhoseStreamsItCancels) {
  const TwoServers two;
  const Client client(two.address(), Persistent());
  for (int call = 0; call < 5; ++call) {
    const auto stream = client.OpenResumingStream(kPatience);
    stream->Send(StreamFrame());
    EXPECT_TRUE(stream->Receive());
    stream->Cancel();
    EXPECT_THROW(stream->Receive(), RpcError);
  }
  EXPECT_TRUE(FramesOf(*two.a) == 0 || FramesOf(*two.b) == 0);
}

TEST(Fleet, AnotherServerTakesWhatOneRefuses) {
  testing::Gate gate;
  testing::Loopback busy(std::ref(gate), OneThread());
  const testing::Loopback idle(FindOne, OneThread());
  auto first = std::async(std::launch::async, [&] { busy.client.Detect(testing::TestRequest()); });
  gate.WaitUntilBegun();
  ClientOptions once = Persistent();
  once.retry.max_attempts = 1;
  // Whichever of the two they begin with.
  for (int call = 0; call < 10; ++call) {
    const Client client(busy.server.Address() + "," + idle.server.Address(), once);
    EXPECT_NO_THROW(client.Detect(testing::TestRequest()));
  }
  gate.Let();
  first.get();
}

TEST(Fleet, SaysTheLeastWaitWhereAllRefuse) {
  testing::Gate gate;
  testing::Loopback a(std::ref(gate), OneThread()), b(std::ref(gate), OneThread());
  std::vector<std::future<void>> held;
  for (testing::Loopback* each : {&a, &b}) {
    held.push_back(
        std::async(std::launch::async, [each] { each->client.Detect(testing::TestRequest()); }));
    gate.WaitUntilBegun();
  }
  ClientOptions once = Persistent();
  once.retry.max_attempts = 1;
  try {
    Client(a.server.Address() + "," + b.server.Address(), once).Detect(testing::TestRequest());
    FAIL() << "a frame was answered that no server had room for";
  } catch (const RpcError& error) {
    EXPECT_EQ(error.code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_TRUE(error.retry_after());
  }
  gate.Let(2);
}

TEST(Fleet, OneAttemptIsEnoughWhereOneServerIsAway) {
  TwoServers two;
  const std::string address = two.address();
  ClientOptions once = Persistent();
  once.retry.max_attempts = 1;
  two.a.reset();
  for (int call = 0; call < 10; ++call) {
    EXPECT_NO_THROW(Client(address, once).Detect(testing::TestRequest()));
  }
}

TEST(Fleet, AStreamGoesOnAtTheOtherServer) {
  TwoServers two;
  const Client client(two.address(), Persistent());
  const auto stream = client.OpenResumingStream(kPatience);
  stream->Send(StreamFrame());
  EXPECT_EQ(stream->Receive()->response.sequence(), 0U);
  const bool at_a = FramesOf(*two.a) > 0;
  const auto receive = [&] { return stream->Receive(); };
  auto answer = std::async(std::launch::async, receive);
  (at_a ? two.a : two.b).reset();
  std::uint64_t num_sent = 1;
  while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    stream->Send(StreamFrame());
    ++num_sent;
  }
  const auto got = answer.get();
  ASSERT_TRUE(got);
  EXPECT_EQ(got->response.sequence(), got->lost + got->response.dropped() + 1);
  EXPECT_GT(FramesOf(at_a ? *two.b : *two.a), 0);
}

TEST(Fleet, AStreamOfGreatAgeIsOpenedAgain) {
  server::ServerOptions options = LoopbackOptions();
  options.max_connection_age_s = 1;
  const testing::Loopback loopback(FindOne, options);
  {
    const auto plain = loopback.client.OpenStream(kPatience);
    EXPECT_EQ(testing::StatusOf([&] { plain->Receive(); }).error_code(),
              grpc::StatusCode::UNAVAILABLE);
    EXPECT_TRUE(plain->context().GetServerTrailingMetadata().contains("retry-after-ms"));
  }
  const Client client(loopback.server.Address(), Persistent());
  const auto stream = client.OpenResumingStream(kPatience);
  std::atomic<bool> resumed = false;
  std::jthread sender([&] {
    while (!resumed) {
      stream->Send(StreamFrame());
      std::this_thread::yield();
    }
    stream->DoneSending();
  });
  std::uint64_t num_known = 0;
  while (const auto answer = stream->Receive()) {
    resumed = resumed || answer->lost > 0;  // what was sent while the stream ended
    num_known += 1 + answer->lost + answer->response.dropped();
    EXPECT_EQ(answer->response.sequence() + 1, num_known);
  }
}

}  // namespace
}  // namespace fovea::client
