// Trying options: what comes back, who may, and that robots notice nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "server/error_details.h"
#include "tests/server/detectors.h"
#include "tests/server/metric_value.h"
#include "tests/server/observers.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::TryRequest Trial(const std::string& robot = "hall") {
  v1::TryRequest request;
  request.set_robot(robot);
  *request.mutable_frame() = TestFrame();
  return request;
}

struct Tried {
  grpc::Status status = {};
  v1::TryResponse response = {};
  bool says_when = false;  // to come back
};

Tried TryAs(const std::string& address, const std::string& token, const v1::TryRequest& request) {
  Tried tried;
  tried.status = AskAs(address, token, [&](auto& stub, grpc::ClientContext* context) {
    grpc::Status status = stub.Try(context, request, &tried.response);
    tried.says_when = context->GetServerTrailingMetadata().contains("retry-after-ms");
    return status;
  });
  return tried;
}

class ObserversTry : public Observers {};

TEST_F(ObserversTry, GetTheAnswerThatARobotWouldGet) {
  const Loopback loopback(fovea::Detect, options_);
  v1::DetectRequest request = TestRequest();
  request.mutable_options()->set_return_masks(true);
  v1::TryRequest trial = Trial();
  *trial.mutable_options() = request.options();
  v1::Detections wanted = loopback.client.Detect(request).detections();
  Tried tried = TryAs(loopback.server.Address(), "all-of-it", trial);
  ASSERT_TRUE(tried.status.ok()) << tried.status.error_message();
  wanted.clear_stage_times();
  tried.response.mutable_detections()->clear_stage_times();
  EXPECT_EQ(tried.response.detections().SerializeAsString(), wanted.SerializeAsString());
}

TEST_F(ObserversTry, LeaveNoTraceOfIt) {
  const Loopback loopback(FindOne, options_);
  const server::Metrics& metrics = *loopback.server.metrics();
  const auto before = loopback.client.GetStatistics();
  ASSERT_TRUE(TryAs(loopback.server.Address(), "all-of-it", Trial()).status.ok());
  const auto after = loopback.client.GetStatistics();
  EXPECT_EQ(after.frames_received(), before.frames_received());
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_answered_total"), 0);
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_tried_total"), 1);
}

TEST_F(ObserversTry, NeedTheRightAndTheRobot) {
  const Loopback loopback(FindOne, options_);
  const std::string address = loopback.server.Address();
  EXPECT_EQ(TryAs(address, "nonsense", Trial()).status.error_code(),
            grpc::StatusCode::UNAUTHENTICATED);
  const grpc::Status no_right = TryAs(address, "kitchens", Trial()).status;
  EXPECT_EQ(no_right.error_code(), grpc::StatusCode::PERMISSION_DENIED);
  EXPECT_THAT(no_right.error_message(), HasSubstr("no right try"));
  folder_.Write("observers", Line("cat", "trier", "view,try", "kitchen-*"));
  const Loopback other(FindOne, options_);
  EXPECT_TRUE(TryAs(other.server.Address(), "trier", Trial("kitchen-1")).status.ok());
  EXPECT_EQ(TryAs(other.server.Address(), "trier", Trial("hall")).status.error_code(),
            grpc::StatusCode::PERMISSION_DENIED);
}

TEST_F(ObserversTry, AreToldOfMistakesAsRobotsAre) {
  const Loopback loopback(FindOne, options_);
  const auto error_of = [&](auto change) {
    v1::TryRequest request = Trial();
    change(request);
    const grpc::Status status = TryAs(loopback.server.Address(), "all-of-it", request).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_NE(server::FieldOf(status), "") << "programs are told the field";
    return status.error_message();
  };
  EXPECT_THAT(
      error_of([](auto& r) { (*r.mutable_options()->mutable_parameters())["no.such"] = 1; }),
      StartsWith("options.parameters"));
  EXPECT_THAT(error_of([](auto& r) { r.mutable_frame()->mutable_depth()->set_data("short"); }),
              StartsWith("frame.depth.data: "));
  EXPECT_THAT(error_of([](auto& r) { r.clear_frame(); }), StartsWith("frame: "));
  EXPECT_THAT(error_of([](auto& r) { r.clear_robot(); }), StartsWith("robot: "));
  EXPECT_THAT(error_of([](auto& r) { r.mutable_options()->mutable_tracking()->set_enabled(true); }),
              StartsWith("options.tracking"));
}

TEST_F(ObserversTry, AreRefusedWhereTooManyDo) {
  Gate gate;
  const Loopback loopback(std::ref(gate), options_);
  const auto try_one = [&] { return TryAs(loopback.server.Address(), "all-of-it", Trial()); };
  auto first = std::async(std::launch::async, try_one);
  gate.WaitUntilBegun();
  auto second = std::async(std::launch::async, try_one);
  // One of these two waits, the other is refused: two of one person are the most.
  auto third = std::async(std::launch::async, try_one);
  while (second.wait_for(std::chrono::seconds(0)) != std::future_status::ready &&
         third.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    std::this_thread::yield();
  }
  gate.Let(2);
  const std::vector<Tried> all{first.get(), second.get(), third.get()};
  int refused = 0;
  for (const Tried& tried : all) {
    if (tried.status.ok()) continue;
    ++refused;
    EXPECT_EQ(tried.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_THAT(tried.status.error_message(), HasSubstr("2 frames of ann are tried already"));
    EXPECT_TRUE(tried.says_when);
  }
  EXPECT_EQ(refused, 1);
}

TEST_F(ObserversTry, DoNotTakeTheThreadsOfRobots) {
  Gate gate;
  options_.compute_threads = 1;
  const Loopback loopback(std::ref(gate), options_);
  auto trial = std::async(std::launch::async,
                          [&] { return TryAs(loopback.server.Address(), "all-of-it", Trial()); });
  gate.WaitUntilBegun();
  auto robot = std::async(std::launch::async, [&] { Detect(loopback, "hall"); });
  gate.WaitUntilBegun();  // while the other is under way
  gate.Let(2);
  robot.get();
  EXPECT_TRUE(trial.get().status.ok());
}

TEST_F(ObserversTry, GiveUpWhenTheyLeave) {
  Endless endless;
  const Loopback loopback(std::ref(endless), options_);
  auto begun = endless.started.get_future();
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer all-of-it");
  auto trial = std::async(std::launch::async, [&] {
    const auto stub = v1::ObservationService::NewStub(
        grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
    v1::TryResponse response;
    return stub->Try(&context, Trial(), &response);
  });
  begun.wait();
  context.TryCancel();
  EXPECT_EQ(trial.get().error_code(), grpc::StatusCode::CANCELLED);
}

TEST_F(ObserversTry, AreToldWhatOptionsThereAre) {
  const Loopback loopback(FindOne, options_);
  v1::ListOptionsResponse options;
  const auto ask = [&](const std::string& token) {
    return AskAs(loopback.server.Address(), token, [&](auto& stub, grpc::ClientContext* context) {
      return stub.ListOptions(context, {}, &options);
    });
  };
  ASSERT_TRUE(ask("all-of-it").ok());
  EXPECT_EQ(options.SerializeAsString().size(),
            loopback.client.ListOptions().SerializeAsString().size());
  EXPECT_GT(options.options_size(), 10);
  EXPECT_EQ(ask("kitchens").error_code(), grpc::StatusCode::PERMISSION_DENIED);
}

}  // namespace
}  // namespace fovea::testing
