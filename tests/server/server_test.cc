// Starting, health, reflection and stopping.
#include "server/server.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <future>
#include <opencv2/core.hpp>
#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

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
  EXPECT_THAT(error_of([](auto& o) { o.log_level = "loud"; }), HasSubstr("\"loud\" is not one"));
  for (const char* listen : {"", "50051", ":50051", "host:", "host:x", "host:-1", "host:65536"}) {
    EXPECT_THAT(error_of([&](auto& o) { o.listen = listen; }), HasSubstr("--listen: ")) << listen;
  }
}

TEST(Server, RefusesAPortThatIsTaken) {
  const Loopback first;
  server::ServerOptions options;
  options.listen = first.server.Address();
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

TEST(Server, ReportsNotServingWhenItDrains) {
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

  auto drained = std::async(std::launch::async, [&] { loopback.server.Drain(); });
  ASSERT_TRUE(watch->Read(&response));
  EXPECT_EQ(response.status(), HealthResponse::NOT_SERVING);
  context.TryCancel();
  watch->Finish();
  drained.wait();
}

TEST(Server, LetsACallFinishWhileItDrains) {
  std::promise<void> started, go_on;
  Loopback loopback([&](const RgbdFrame& frame, auto&&...) {
    started.set_value();
    go_on.get_future().wait();
    Detections detections;
    detections.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
    return detections;
  });
  auto answer =
      std::async(std::launch::async, [&] { return loopback.client.Detect(TestRequest()); });
  started.get_future().wait();
  auto drained = std::async(std::launch::async, [&] { loopback.server.Drain(); });
  go_on.set_value();
  EXPECT_EQ(answer.get().detections().frame_id(), "frame-7");
  drained.wait();
}

TEST(Server, CancelsWhatOutlastsTheDrain) {
  server::ServerOptions options = LoopbackOptions();
  options.drain_timeout_s = 0;
  std::promise<void> started;
  Loopback loopback(
      [&](const RgbdFrame&, const DetectorOptions&, Trace*,
          const std::function<bool()>& should_stop) -> Detections {
        started.set_value();
        while (!should_stop()) std::this_thread::yield();
        throw Cancelled();
      },
      options);
  auto status = std::async(
      std::launch::async, [&] { return StatusOf([&] { loopback.client.Detect(TestRequest()); }); });
  started.get_future().wait();
  loopback.server.Drain();
  EXPECT_FALSE(status.get().ok());
}

}  // namespace
}  // namespace fovea::testing
