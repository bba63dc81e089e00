// Turns, limits and abandoned calls over real connections; a gate holds the one compute thread.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include "client/images.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/server/waiting_calls.h"

namespace fovea::testing {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

server::ServerOptions OneThread(int max_waiting, int max_per_robot) {
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  options.max_waiting = max_waiting;
  options.max_per_robot = max_per_robot;
  return options;
}

TEST(Scheduling, RobotsTakeTurns) {
  std::mutex mutex;
  constexpr double kPlausible_px = 30;
  std::vector<double> order;  // of fx beyond that, by which the frames are told apart
  Gate gate;
  Loopback loopback(
      [&](const RgbdFrame& frame, auto&&... rest) {
        {
          const std::lock_guard lock(mutex);
          order.push_back(frame.intrinsics.fx_px - kPlausible_px);
        }
        return gate(frame, rest...);
      },
      OneThread(10, 10));
  std::vector<std::jthread> threads;
  int num_waiting = 0;
  const auto send = [&](const std::string& robot, double fx, bool waits) {
    threads.emplace_back([&loopback, robot, fx] {
      Call call(loopback, robot);
      v1::DetectRequest request = TestRequest();
      request.mutable_frame()->mutable_intrinsics()->set_fx(kPlausible_px + fx);
      EXPECT_TRUE(call.stub->Detect(&call.context, request, &call.response).ok());
    });
    if (!waits) return gate.WaitUntilBegun();
    ++num_waiting;
    AwaitWaiting(loopback, num_waiting);
  };
  send("greedy", 1, false);
  for (const double fx : {2, 3, 4}) send("greedy", fx, true);
  send("modest", 11, true);
  send("third", 21, true);
  gate.Let(6);
  threads.clear();
  const std::lock_guard lock(mutex);
  EXPECT_THAT(order, ElementsAre(1, 2, 11, 21, 3, 4));
}

TEST(Scheduling, RefusesAtOnceWhatDoesNotFit) {
  Held held(OneThread(/*max_waiting=*/1, /*max_per_robot=*/10));
  Crowd crowd(held.loopback);
  crowd.Join("second");
  const auto bytes = [&] {
    return MetricValue(*held.loopback.server.metrics(), "fovea_received_bytes_total");
  };
  const double bytes_before = bytes();
  Call call(held.loopback, "third");
  const grpc::Status status = call.Run();  // returns although nothing is computed
  EXPECT_EQ(bytes(), bytes_before) << "refused before the frame was read";
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("the queue is full with 2 frames"));
  EXPECT_GE(std::stoi(call.Trailer("retry-after-ms")), 10);
  EXPECT_EQ(MetricValue(*held.loopback.server.metrics(), "fovea_refused_total", "QUEUE_FULL"), 1);
  AwaitMetric(*held.loopback.server.metrics(), "fovea_refusal_seconds", 1);
  held.gate.Let(2);
  EXPECT_THAT(crowd.Answered(), ElementsAre("second"));
  EXPECT_TRUE(held.first.get().ok());
}

// Refused, as nothing is computed; returns what the server says of it.
std::string RefusalOf(const Loopback& loopback, const std::string& robot) {
  const grpc::Status status = Call(loopback, robot).Run();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED) << robot;
  return status.error_message();
}

// A place in line is kept for a moment, which a slow machine may miss; then others try.
TEST(Scheduling, KeepsAPlaceForWhomItTurnsAway) {
  Held held(OneThread(/*max_waiting=*/0, /*max_per_robot=*/10));
  const auto end = std::chrono::steady_clock::now() + kPatience;
  std::string refusal;
  for (int robot = 0; refusal.find("in line") == std::string::npos; ++robot) {
    ASSERT_LT(std::chrono::steady_clock::now(), end);
    refusal = RefusalOf(held.loopback, "robot-" + std::to_string(robot));
  }
  EXPECT_THAT(refusal, HasSubstr("1 robots in line"));
}

TEST(Scheduling, KeepsNoPlaceForWhoComesOnlyIfThereIsRoom) {
  Held held(OneThread(/*max_waiting=*/0, /*max_per_robot=*/10));
  Call call(held.loopback, "second");
  call.context.AddMetadata("fovea-only-if-room", "1");
  EXPECT_EQ(call.Run().error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(RefusalOf(held.loopback, "third"), Not(HasSubstr("in line")));
}

TEST(Scheduling, OneRobotCannotTakeAllPlaces) {
  Held held(OneThread(/*max_waiting=*/4, /*max_per_robot=*/1));
  Call again(held.loopback, "first");
  const grpc::Status status = again.Run();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("this robot has 1 frames"));
  EXPECT_EQ(MetricValue(*held.loopback.server.metrics(), "fovea_refused_total", "ROBOT_LIMIT"), 1);
  Crowd crowd(held.loopback);
  crowd.Join("other");
  held.gate.Let(2);
  EXPECT_THAT(crowd.Answered(), ElementsAre("other"));
}

TEST(Scheduling, APlaceIsFreeAgainWhenTheAnswerIsThere) {
  Gate gate;
  Loopback loopback(std::ref(gate), OneThread(0, 1));
  gate.Let(50);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(Call(loopback, "only").Run().ok());
}

TEST(Scheduling, ComputesAtLowerPriorityThanItRefuses) {
  server::ServerOptions options = LoopbackOptions();
  options.compute_nice = 3;
  int niceness = 0;  // on Linux it is the thread's
  Loopback loopback(
      [&](auto&&... frame) {
        niceness = getpriority(PRIO_PROCESS, 0);
        return FindOne(frame...);
      },
      options);
  EXPECT_TRUE(Call(loopback, "robot").Run().ok());
  EXPECT_EQ(niceness, std::min(19, getpriority(PRIO_PROCESS, 0) + 3));
}

TEST(Scheduling, DropsFromTheQueueWhoseCallerLeft) {
  Held held(OneThread(10, 10));
  Crowd crowd(held.loopback);
  crowd.Join("stays");
  crowd.Join("leaves");
  crowd.LeaveLast();
  AwaitWaiting(held.loopback, 1);  // although the compute thread has not moved
  held.gate.Let(2);
  EXPECT_THAT(crowd.Answered(), UnorderedElementsAre("no leaves", "stays"));
}

TEST(Scheduling, DropsFromTheQueueWhatIsTooLate) {
  Held held(OneThread(10, 10));
  const grpc::Status status =
      StatusOf([&] { held.loopback.client.Detect(TestRequest(), std::chrono::milliseconds(100)); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  AwaitWaiting(held.loopback, 0);
}

// 22 MB, the largest by default.
v1::DetectRequest LargeRequest() {
  constexpr int kLargeWidth = 2048, kLargeHeight = 1536;
  const std::vector<float> depth_m(std::size_t{kLargeWidth} * kLargeHeight, 1);
  v1::DetectRequest request = TestRequest();
  v1::Frame& frame = *request.mutable_frame();
  *frame.mutable_color() = ColorMessage(
      v1::COLOR_ENCODING_RGB8, std::string(3 * depth_m.size(), 'x'), kLargeWidth, kLargeHeight);
  *frame.mutable_depth() = client::MakeDepthImage(depth_m.data(), kLargeWidth, kLargeHeight);
  *frame.mutable_intrinsics() =
      client::MakeIntrinsics(kLargeWidth, kLargeWidth, kLargeWidth / 2.0, kLargeHeight / 2.0);
  return request;
}

// More than all calls and streams may send in part: gRPC, had it no more, would give up any.
TEST(Scheduling, LargeFramesThatWaitEndNoCalls) {
  constexpr int kCalls = 8;
  server::ServerOptions options = OneThread(kCalls, kCalls + 1);
  options.max_receiving_mib = 6 * options.max_message_mib;
  Held held(options);
  Crowd crowd(held.loopback);
  const v1::DetectRequest large = LargeRequest();
  for (int i = 0; i < kCalls; ++i) crowd.Join("large", large);
  held.gate.Let(kCalls + 1);
  EXPECT_THAT(crowd.Answered(), AllOf(SizeIs(kCalls), Each("large")));
  EXPECT_TRUE(held.first.get().ok());
}

TEST(Scheduling, SurvivesAStormOfDeadlines) {
  Held held(OneThread(1000, 1000));
  std::vector<std::jthread> callers;
  callers.reserve(20);
  for (int caller = 0; caller < 20; ++caller) {
    callers.emplace_back([&held] {
      for (int call = 0; call < 10; ++call) {
        const auto status = StatusOf(
            [&] { held.loopback.client.Detect(TestRequest(), std::chrono::milliseconds(5)); });
        EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
      }
    });
  }
  callers.clear();
  AwaitWaiting(held.loopback, 0);
  held.gate.Let(100);
  EXPECT_TRUE(held.first.get().ok());
  EXPECT_TRUE(Call(held.loopback, "late").Run().ok());
}

TEST(Scheduling, ReturnsTheIdOfTheRequest) {
  const Loopback loopback(FindOne);
  Call named(loopback, "robot"), nameless(loopback, "robot");
  named.context.AddMetadata("fovea-request-id", "mine-1");
  EXPECT_TRUE(named.Run().ok());
  EXPECT_EQ(named.Trailer("fovea-request-id"), "mine-1");
  EXPECT_TRUE(nameless.Run().ok());
  EXPECT_GT(std::stoi(nameless.Trailer("fovea-request-id")), 0);
}

TEST(Scheduling, RefusesARobotsNameThatCannotBe) {
  Loopback loopback(FindOne);
  const grpc::Status status = Call(loopback, std::string(65, 'x')).Run();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("metadata fovea-robot: "));
}

}  // namespace
}  // namespace fovea::testing
