// Starting, health, reflection and stopping.
#include "server/server.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <opencv2/core.hpp>
#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using HealthResponse = grpc::health::v1::HealthCheckResponse;

TEST(ServerOptions, NameFlagValueAndConstraint) {
  const auto error_of = [](auto change) -> std::string {
    server::ServerOptions options;
    change(options);
    try {
      Validate(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "valid";
  };
  EXPECT_EQ(error_of([](auto&) {}), "valid");
  EXPECT_EQ(error_of([](auto& o) { o.max_message_mib = 0; }),
            "--max-message-mib: 0 is not between 1 and 1024");
  EXPECT_EQ(error_of([](auto& o) { o.max_pixels = -1; }),
            "--max-pixels: -1 is not between 1 and 100000000");
  EXPECT_EQ(error_of([](auto& o) { o.max_receiving_mib = 143; }),
            "--max-receiving-mib: 143 is less than six messages of --max-message-mib (24), which "
            "are 144; raise it, or lower --max-message-mib");
  EXPECT_EQ(error_of([](auto& o) { o.max_receiving_mib = 144; }), "valid");
  EXPECT_EQ(error_of([](auto& o) {
              o.max_receiving_mib = 16;
              o.max_message_mib = 2;
            }),
            "valid");
  EXPECT_THAT(error_of([](auto& o) { o.log_level = "loud"; }), HasSubstr("\"loud\" is not one"));
  for (const char* listen : {"", "50051", ":50051", "host:", "host:x", "host:-1", "host:65536"}) {
    EXPECT_THAT(error_of([&](auto& o) { o.listen = {listen}; }), HasSubstr("--listen: ")) << listen;
  }
}

TEST(Server, RefusesAPortThatIsTaken) {
  const Loopback first;
  server::ServerOptions options;
  options.listen = {first.server.Address()};
  EXPECT_THAT([&] { server::Server second(options); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot listen on 127.0.0.1:")));
}

TEST(Server, ReportsHealthForItselfAndTheService) {
  const Loopback loopback;
  loopback.client.WaitUntilReady(kPatience);
  EXPECT_TRUE(loopback.client.IsServing());

  const auto channel =
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials());
  grpc::ClientContext context;
  HealthResponse response;
  const auto status = grpc::health::v1::Health::NewStub(channel)->Check(&context, {}, &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(response.status(), HealthResponse::SERVING);
}

// Reflection's messages belong to gRPC's own library, so this speaks their bytes.
TEST(Server, ListsItsServicesByReflection) {
  const Loopback loopback;
  grpc::GenericStub stub(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto wait = [&queue] {
    void* tag = nullptr;
    bool ok = false;
    return queue.Next(&tag, &ok) && ok;
  };
  const auto call = stub.PrepareCall(
      &context, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", &queue);
  call->StartCall(nullptr);
  ASSERT_TRUE(wait());
  const grpc::Slice list_services("\x3A\x01*");  // field 7, one byte
  call->Write(grpc::ByteBuffer(&list_services, 1), nullptr);
  ASSERT_TRUE(wait());
  grpc::ByteBuffer answer;
  call->Read(&answer, nullptr);
  ASSERT_TRUE(wait());
  grpc::Slice bytes;
  ASSERT_TRUE(answer.DumpToSingleSlice(&bytes).ok());
  const std::string text(reinterpret_cast<const char*>(bytes.begin()), bytes.size());
  EXPECT_THAT(text, HasSubstr("fovea.v1.DetectionService"));
  EXPECT_THAT(text, HasSubstr("grpc.health.v1.Health"));
  context.TryCancel();
  grpc::Status status;
  call->Finish(&status, nullptr);
  wait();
}

TEST(Server, ClosesConnectionsWithoutACall) {
  server::ServerOptions options = LoopbackOptions();
  options.max_idle_s = 1;
  const Loopback loopback(FindOne, options);
  const auto channel =
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials());
  const auto deadline = std::chrono::system_clock::now() + kPatience;
  ASSERT_TRUE(channel->WaitForConnected(deadline));
  ASSERT_TRUE(channel->WaitForStateChange(GRPC_CHANNEL_READY, deadline));
  EXPECT_TRUE(channel->WaitForConnected(deadline)) << "the next call connects again";
}

TEST(Server, ServesOnWhileItNoLongerAdvertises) {
  Loopback loopback(FindOne);
  loopback.server.StopAdvertising();
  EXPECT_FALSE(loopback.client.IsServing());
  EXPECT_NO_THROW(loopback.client.Detect(TestRequest()));
}

// Whoever only watches the health does not hold up the end.
TEST(Server, TellsWatchersThatItDrains) {
  Loopback loopback;
  const auto channel =
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials());
  grpc::ClientContext context;
  grpc::health::v1::HealthCheckRequest request;
  request.set_service("fovea.v1.DetectionService");
  const auto watch = grpc::health::v1::Health::NewStub(channel)->Watch(&context, request);
  HealthResponse response;
  ASSERT_TRUE(watch->Read(&response));
  EXPECT_EQ(response.status(), HealthResponse::SERVING);
  loopback.server.StopAdvertising();
  ASSERT_TRUE(watch->Read(&response));
  EXPECT_EQ(response.status(), HealthResponse::NOT_SERVING);
  loopback.server.Drain();
  while (watch->Read(&response)) EXPECT_EQ(response.status(), HealthResponse::NOT_SERVING);
  EXPECT_FALSE(watch->Finish().ok());
}

TEST(Server, RefusesNewCallsWhileItDrains) {
  Gate gate;
  Loopback loopback(std::ref(gate));
  auto accepted = std::async(std::launch::async, [&] { loopback.client.Detect(TestRequest()); });
  gate.WaitUntilBegun();
  auto drained = std::async(std::launch::async, [&] { loopback.server.Drain(); });
  // Streams, since an idle one that was let in would be ended with the same words.
  grpc::Status status;
  do {
    status = StatusOf([&] { loopback.client.OpenStream(kPatience)->Receive(); });
  } while (status.error_code() == grpc::StatusCode::CANCELLED);  // by gRPC, as it begins to end
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  gate.Let();
  EXPECT_NO_THROW(accepted.get());
  drained.wait();
}

// Every call that was let in is answered, however many there are when the end comes.
TEST(Server, LosesNothingAcceptedWhenItDrainsUnderLoad) {
  server::ServerOptions options = LoopbackOptions();
  options.max_waiting = options.max_per_robot = 100;
  Loopback loopback(FindOne, options);
  std::atomic<int> num_answered = 0;
  std::vector<std::jthread> callers;
  callers.reserve(8);
  for (int caller = 0; caller < 8; ++caller) {
    callers.emplace_back([&] {
      try {
        while (true) {
          loopback.client.Detect(TestRequest());
          ++num_answered;
        }
      } catch (const client::RpcError& error) {
        // gRPC cancels calls that come while it shuts down.
        EXPECT_THAT(error.code(), AnyOf(grpc::StatusCode::UNAVAILABLE, grpc::StatusCode::CANCELLED))
            << error.what();
      }
    });
  }
  while (num_answered < 100) std::this_thread::yield();
  loopback.server.Drain();
  callers.clear();
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_objects_total"), num_answered);
}

TEST(Server, LetsACallFinishWhileItDrains) {
  Gate gate;
  Loopback loopback(std::ref(gate));
  auto answer =
      std::async(std::launch::async, [&] { return loopback.client.Detect(TestRequest()); });
  gate.WaitUntilBegun();
  auto drained = std::async(std::launch::async, [&] { loopback.server.Drain(); });
  gate.Let();
  EXPECT_EQ(answer.get().detections().frame_id(), "frame-7");
  drained.wait();
}

TEST(Server, CancelsWhatOutlastsTheDrain) {
  server::ServerOptions options = LoopbackOptions();
  options.drain_timeout_s = 0;
  Endless detector;
  Loopback loopback(std::ref(detector), options);
  auto status = std::async(
      std::launch::async, [&] { return StatusOf([&] { loopback.client.Detect(TestRequest()); }); });
  detector.started.get_future().wait();
  const CapturedLog log;
  loopback.server.Drain();
  EXPECT_FALSE(status.get().ok());
  EXPECT_THAT(log.text(), HasSubstr("code=UNAVAILABLE"));
  EXPECT_THAT(log.text(),
              HasSubstr("the server has stopped before the answer (--drain-timeout-s)"));
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_frames_answered_total", "UNAVAILABLE"),
            1);
}

}  // namespace
}  // namespace fovea::testing
