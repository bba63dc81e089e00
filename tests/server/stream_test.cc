// DetectStream over real loopback; a gate decides when a frame is done.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/server/raw_stream.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::DetectStreamRequest FrameNamed(const std::string& id) {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  request.mutable_frame()->set_id(id);
  return request;
}

TEST(DetectStream, OutlivesBadFrames) {
  Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  const std::vector<bool> good{true, false, true, false, false, true};
  for (std::size_t i = 0; i < good.size(); ++i) {
    SCOPED_TRACE(i);
    const std::string id = fmt::format("f{}", i);
    v1::DetectStreamRequest request = FrameNamed(id);
    if (!good[i]) request.mutable_frame()->clear_depth();
    ASSERT_TRUE(stream->Send(request));
    const auto response = stream->Receive();
    ASSERT_TRUE(response);
    EXPECT_EQ(response->sequence(), i);
    EXPECT_EQ(response->frame_id(), id);
    EXPECT_EQ(response->dropped(), 0U);
    EXPECT_EQ(response->has_detections(), good[i]);
    if (good[i]) continue;
    EXPECT_EQ(response->error().code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_THAT(response->error().message(), StartsWith("frame.depth: "));
  }
  stream->DoneSending();
  EXPECT_FALSE(stream->Receive());
}

TEST(DetectStream, DropsAllButTheNewestFrame) {
  Gate gate;
  Loopback loopback(std::ref(gate));
  const auto stream = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(stream->Send(FrameNamed("0")));
  gate.WaitUntilBegun();
  for (int i = 1; i <= 9; ++i) ASSERT_TRUE(stream->Send(FrameNamed(std::to_string(i))));
  stream->DoneSending();
  AwaitMetric(*loopback.server.metrics(), "fovea_frames_dropped_total", 8);
  gate.Let(2);

  const auto first = stream->Receive();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame_id(), "0");
  EXPECT_EQ(first->dropped(), 0U);
  const auto last = stream->Receive();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->frame_id(), "9");
  EXPECT_EQ(last->sequence(), 9U);
  EXPECT_EQ(last->dropped(), 8U);
  EXPECT_FALSE(stream->Receive());
}

TEST(DetectStream, KeepsTheLastOptions) {
  Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  const auto masks_after = [&](const std::function<void(v1::DetectStreamRequest&)>& change) {
    v1::DetectStreamRequest request = FrameNamed("any");
    change(request);
    stream->Send(request);
    return stream->Receive()->detections().objects(0).has_mask();
  };
  EXPECT_FALSE(masks_after([](auto&) {}));
  EXPECT_TRUE(masks_after([](auto& r) { r.mutable_options()->set_return_masks(true); }));
  EXPECT_TRUE(masks_after([](auto&) {}));
  EXPECT_FALSE(masks_after([](auto& r) { r.mutable_options(); }));
}

TEST(DetectStream, OptionsOfADroppedFrameHold) {
  Gate gate;
  Loopback loopback(std::ref(gate));
  const auto stream = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(stream->Send(FrameNamed("0")));
  gate.WaitUntilBegun();
  v1::DetectStreamRequest dropped = FrameNamed("1");
  dropped.mutable_options()->set_return_masks(true);
  ASSERT_TRUE(stream->Send(dropped));
  ASSERT_TRUE(stream->Send(FrameNamed("2")));
  AwaitMetric(*loopback.server.metrics(), "fovea_frames_dropped_total", 1);
  gate.Let(2);
  EXPECT_FALSE(stream->Receive()->detections().objects(0).has_mask());
  EXPECT_TRUE(stream->Receive()->detections().objects(0).has_mask());
}

TEST(DetectStream, SaysWhereThereIsNoRoomForAFrame) {
  Gate gate;
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  options.max_receiving_mib = 144;
  Loopback loopback(std::ref(gate), options);
  const server::Metrics& metrics = *loopback.server.metrics();
  const auto greedy = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(greedy->Send(FrameNamed("0")));
  gate.WaitUntilBegun();
  v1::DetectStreamRequest large = FrameNamed("1");
  large.mutable_frame()->mutable_color()->set_data(std::string(22 << 20, 'x'));
  ASSERT_TRUE(greedy->Send(large));
  AwaitMetric(metrics, "fovea_frames_received_total", 2);

  const auto other = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest refused = FrameNamed("2");
  refused.mutable_options()->set_return_masks(true);
  refused.mutable_frame()->mutable_color()->set_data(std::string(22 << 20, 'x'));
  ASSERT_TRUE(other->Send(refused));
  AwaitMetric(metrics, "fovea_frames_received_total", 3);
  gate.Let(2);
  const v1::DetectStreamResponse answer = *other->Receive();
  EXPECT_EQ(answer.error().code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(answer.error().message(), HasSubstr("--max-receiving-mib"));
  EXPECT_EQ(answer.error().retry_after().seconds(), 1);
  ASSERT_TRUE(other->Send(FrameNamed("3")));
  EXPECT_TRUE(other->Receive()->detections().objects(0).has_mask()) << "its options hold";
}

// Garbage where a message should be, between good frames.
TEST(DetectStream, OutlivesMessagesThatAreNone) {
  Loopback loopback(FindOne);
  RawStream stream(loopback.server.Address());
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    EXPECT_TRUE(stream.Exchange(FrameNamed("good").SerializeAsString()).has_detections());
    const v1::DetectStreamResponse bad = stream.Exchange("\xFF\xFF\xFF");
    EXPECT_EQ(bad.error().code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(bad.error().message(), "the message is not a DetectStreamRequest");
    EXPECT_EQ(bad.sequence(), 2U * i + 1);
  }
}

TEST(DetectStream, KeepsNoOptionsOfMessagesThatAreNone) {
  Loopback loopback(FindOne);
  RawStream stream(loopback.server.Address());
  v1::DetectStreamRequest request;
  request.mutable_options()->set_return_masks(true);
  EXPECT_TRUE(stream.Exchange(request.SerializeAsString() + "\xFF\xFF\xFF").has_error());
  const v1::DetectStreamResponse next = stream.Exchange(FrameNamed("1").SerializeAsString());
  EXPECT_FALSE(next.detections().objects(0).has_mask());
}

TEST(DetectStream, KeepsNoOptionsThatAreTooLarge) {
  Loopback loopback(FindOne);
  RawStream stream(loopback.server.Address());
  v1::DetectStreamRequest large = FrameNamed("0");
  for (int i = 0; i < 40'000; ++i) large.mutable_options()->mutable_grasps()->add_grippers();
  const v1::DetectStreamResponse refused = stream.Exchange(large.SerializeAsString());
  EXPECT_EQ(refused.error().code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(refused.error().message(),
            "the DetectStreamRequest has more than 65536 bytes beside its images");
  EXPECT_TRUE(stream.Exchange(FrameNamed("1").SerializeAsString()).has_detections());
}

TEST(DetectStream, EndsWithTheAnswerItIsAtWhenTheServerStops) {
  Gate gate;
  Loopback loopback(std::ref(gate));
  const auto stream = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(stream->Send(FrameNamed("0")));
  gate.WaitUntilBegun();
  auto drained = std::async(std::launch::async, [&] { loopback.server.Drain(); });
  gate.Let();
  EXPECT_EQ(stream->Receive()->frame_id(), "0");
  const grpc::Status status = StatusOf([&] { stream->Receive(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(status.error_message(), "the server is stopping");
}

TEST(DetectStream, EndsWhenTheServerStopsAlthoughNothingIsSent) {
  Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  stream->Send(FrameNamed("0"));
  stream->Receive();
  loopback.server.Drain();  // needs no patience
  EXPECT_EQ(StatusOf([&] { stream->Receive(); }).error_message(), "the server is stopping");
}

// Who does not read his answers neither holds a compute thread nor fills the memory.
TEST(DetectStream, ASlowReaderHoldsUpNobody) {
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  Loopback loopback(FindOne, options);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request = FrameNamed("slow");
  request.mutable_options()->set_return_saliency_maps(true);
  std::jthread sender([&] {
    while (stream->Send(request)) {
    }
  });
  // Once frames are dropped the answers are stuck in the connection.
  while (MetricValue(*loopback.server.metrics(), "fovea_frames_dropped_total") < 100) {
    EXPECT_NO_THROW(loopback.client.Detect(TestRequest()));
  }
  stream->Cancel();
  sender.join();
  AwaitMetric(*loopback.server.metrics(), "fovea_streams", 0);
}

TEST(DetectStream, CountsAndLogsTheFrameThatWaitsWhenItEnds) {
  const CapturedLog log;
  Gate gate;
  Loopback loopback(std::ref(gate));
  const server::Metrics& metrics = *loopback.server.metrics();
  const auto stream = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(stream->Send(FrameNamed("0")));
  gate.WaitUntilBegun();
  ASSERT_TRUE(stream->Send(FrameNamed("1")));
  AwaitMetric(metrics, "fovea_frames_received_total", 2);
  stream->Cancel();
  gate.Let();
  AwaitMetric(metrics, "fovea_streams", 0);
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_answered_total"), 2);
  EXPECT_THAT(log.text(), HasSubstr("frame=\"\" code=CANCELLED"));
}

TEST(DetectStream, IsForgottenWhenTheCallerVanishes) {
  Loopback loopback(FindOne);
  for (int i = 0; i < 50; ++i) {
    const auto stream = loopback.client.OpenStream(kPatience);
    ASSERT_TRUE(stream->Send(FrameNamed("0")));
  }
  AwaitMetric(*loopback.server.metrics(), "fovea_streams", 0);
}

}  // namespace
}  // namespace fovea::testing
