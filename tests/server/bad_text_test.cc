// Text that is no UTF-8, of which half a message can be read: nothing of it goes to anybody.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/metric_value.h"
#include "tests/server/observers.h"
#include "tests/server/raw_call.h"
#include "tests/server/raw_stream.h"

namespace fovea::testing {
namespace {

constexpr const char* kHalfOfAPair = "\xed\xa0\xbd";  // of UTF-16

// Requests of both methods.
const std::string kBadId = std::string("\x0a\x05\x0a\x03") + kHalfOfAPair;
const std::string kBadProfile = std::string("\x12\x05\x0a\x03") + kHalfOfAPair;

class BadText : public Observers {};

TEST_F(BadText, IsKeptFromObservers) {
  const Loopback loopback(FindOne, options_);
  Watching watching(loopback.server.Address(), "all-of-it",
                    RequestOf({v1::WATCH_PART_FRAME, v1::WATCH_PART_ANSWER}));
  watching.Next();
  for (const std::string& bytes : {kBadId, kBadProfile}) {
    const grpc::Status status =
        RawCall(loopback.server.Address(), "/fovea.v1.DetectionService/Detect", bytes);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    const v1::WatchedFrame frame = watching.Next().frame();
    EXPECT_EQ(frame.error().message(), "the message is not a DetectRequest");
    EXPECT_EQ(frame.frame_id(), "");
    EXPECT_EQ(frame.options().profile(), "");
  }
}

TEST_F(BadText, GetsAnErrorInAStream) {
  const Loopback loopback(FindOne, options_);
  Watching watching(loopback.server.Address(), "all-of-it", RequestOf({v1::WATCH_PART_FRAME}));
  watching.Next();
  RawStream stream(loopback.server.Address());
  for (const std::string& bytes : {kBadId, kBadProfile}) {
    const v1::DetectStreamResponse answer = stream.Exchange(bytes);
    EXPECT_EQ(answer.error().message(), "the message is not a DetectStreamRequest");
    EXPECT_EQ(answer.frame_id(), "");
    EXPECT_EQ(watching.Next().frame().error().message(),
              "the message is not a DetectStreamRequest");
  }
}

TEST(BadTextOfADroppedFrame, IsNoOption) {
  Gate gate;
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  const Loopback loopback(std::ref(gate), options);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  request.mutable_options()->set_return_masks(true);
  ASSERT_TRUE(stream->Send(request));
  gate.WaitUntilBegun();
  v1::DetectStreamRequest dropped = request;
  dropped.mutable_options()->set_profile(kHalfOfAPair);
  ASSERT_TRUE(stream->Send(dropped));
  request.clear_options();
  ASSERT_TRUE(stream->Send(request));
  AwaitMetric(*loopback.server.metrics(), "fovea_frames_dropped_total", 1);
  gate.Let(2);
  stream->Receive();
  EXPECT_EQ(stream->Receive()->detections().objects_size(), 1);
}

}  // namespace
}  // namespace fovea::testing
