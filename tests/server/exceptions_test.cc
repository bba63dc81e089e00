// What is thrown in the midst of a frame: the caller learns whose mistake it is, and all goes on.
#include <gmock/gmock.h>
#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <memory>
#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/rpc/event_loop.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Mishap {
  std::string name;
  std::function<void()> happen;
  grpc::StatusCode code;
  std::string says;
};

std::vector<Mishap> Mishaps() {
  constexpr auto kInternal = grpc::StatusCode::INTERNAL;
  return {
      {"invalid_argument", [] { throw std::invalid_argument("stoi"); }, kInternal,
       "internal error"},
      {"length_error", [] { throw std::length_error("vector"); }, kInternal, "internal error"},
      {"opencv", [] { throw cv::Exception(-1, "assert", "f", "file", 1); }, kInternal, "internal"},
      {"int", [] { throw 1; }, kInternal, "internal error"},
      {"bad_alloc", [] { throw std::bad_alloc(); }, grpc::StatusCode::RESOURCE_EXHAUSTED,
       "not enough memory"},
  };
}

// Memory comes back.
bool IsWorthRetrying(const Mishap& mishap) {
  return mishap.code == grpc::StatusCode::RESOURCE_EXHAUSTED;
}

// Throws at every second frame, what comes next.
class Unlucky {
 public:
  Detections operator()(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                        const std::function<bool()>& should_stop) {
    const std::size_t frame_number = num_frames_++;
    if (frame_number % 2 == 0) mishaps_.at(frame_number / 2).happen();
    return FindOne(frame, options, trace, should_stop);
  }

 private:
  const std::vector<Mishap> mishaps_ = Mishaps();
  std::size_t num_frames_ = 0;
};

TEST(Exceptions, EndTheCallTheyHappenIn) {
  Loopback loopback{Unlucky()};
  for (const Mishap& mishap : Mishaps()) {
    SCOPED_TRACE(mishap.name);
    try {
      loopback.client.Detect(TestRequest());
      ADD_FAILURE() << "the call succeeded";
    } catch (const client::RpcError& error) {
      EXPECT_EQ(error.code(), mishap.code);
      EXPECT_THAT(error.message(), HasSubstr(mishap.says));
      EXPECT_EQ(error.retry_after().has_value(), IsWorthRetrying(mishap));
    }
    EXPECT_EQ(loopback.client.Detect(TestRequest()).detections().objects_size(), 1);
  }
}

TEST(Exceptions, AreTheAnswerToAFrameOfAStream) {
  Loopback loopback{Unlucky()};
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  for (const Mishap& mishap : Mishaps()) {
    SCOPED_TRACE(mishap.name);
    ASSERT_TRUE(stream->Send(request));
    const auto bad = stream->Receive();
    ASSERT_TRUE(bad);
    EXPECT_EQ(bad->error().code(), mishap.code);
    EXPECT_THAT(bad->error().message(), HasSubstr(mishap.says));
    EXPECT_EQ(bad->error().has_retry_after(), IsWorthRetrying(mishap));
    ASSERT_TRUE(stream->Send(request));
    EXPECT_TRUE(stream->Receive()->has_detections());
  }
}

// Only what is wrong with the request is its caller's mistake, wherever else the type is thrown.
TEST(Exceptions, OfTheMethodAreLoggedAndNotTold) {
  const CapturedLog log;
  {
    Loopback loopback([](auto&&...) -> Detections { throw std::invalid_argument("a secret"); });
    const grpc::Status ours = StatusOf([&] { loopback.client.Detect(TestRequest()); });
    EXPECT_EQ(ours.error_code(), grpc::StatusCode::INTERNAL);
    EXPECT_THAT(ours.error_message(), Not(HasSubstr("secret")));
    v1::DetectRequest wrong = TestRequest();
    wrong.mutable_frame()->mutable_intrinsics()->set_fx(-1);
    const grpc::Status theirs = StatusOf([&] { loopback.client.Detect(wrong); });
    EXPECT_EQ(theirs.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_THAT(theirs.error_message(), HasSubstr("intrinsics.fx"));
  }
  EXPECT_THAT(log.text(), HasSubstr("internal error: a secret"));
}

// What the log throws reaches whoever writes to it, here at the line of each frame.
TEST(Exceptions, OfTheRecordCostNoAnswer) {
  const CapturedLog log("frame=");
  {
    Loopback loopback(FindOne);
    EXPECT_EQ(loopback.client.Detect(TestRequest()).detections().objects_size(), 1);
    const auto stream = loopback.client.OpenStream(kPatience);
    v1::DetectStreamRequest request;
    *request.mutable_frame() = TestFrame();
    ASSERT_TRUE(stream->Send(request));
    EXPECT_TRUE(stream->Receive()->has_detections());
  }
  EXPECT_THAT(log.text(), HasSubstr("a frame that was answered is not counted"));
}

TEST(Exceptions, InAnEventEndItsCall) {
  const CapturedLog log("code=RESOURCE_EXHAUSTED");  // which a stream without a place is logged by
  server::ServerOptions options = LoopbackOptions();
  options.max_streams = options.max_streams_per_host = options.max_streams_per_robot = 1;
  {
    Loopback loopback(FindOne, options);
    const auto first = loopback.client.OpenStream(kPatience);
    v1::DetectStreamRequest request;
    *request.mutable_frame() = TestFrame();
    ASSERT_TRUE(first->Send(request));
    ASSERT_TRUE(first->Receive());
    const auto second = loopback.client.OpenStream(kPatience);
    EXPECT_EQ(StatusOf([&] { second->Receive(); }).error_code(), grpc::StatusCode::CANCELLED);
    ASSERT_TRUE(first->Send(request));
    EXPECT_TRUE(first->Receive()->has_detections());
  }
  EXPECT_THAT(log.text(), HasSubstr("a call ends: an exception of unknown type"));
}

TEST(EventLoop, OutlivesWhatAnEventThrows) {
  const CapturedLog log;
  std::promise<void> next;
  grpc::ServerBuilder builder;
  server::EventLoop loop(builder.AddCompletionQueue());
  const std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  grpc::Alarm bad, good;
  const auto now = std::chrono::system_clock::now();
  bad.Set(loop.queue(), now, server::Then([&](bool) {
            good.Set(loop.queue(), now, server::Then([&](bool) { next.set_value(); }));
            throw std::runtime_error("of an event");
          }));
  next.get_future().wait();
  EXPECT_THAT(log.text(), HasSubstr("an event was not handled: of an event"));
  server->Shutdown();
}

}  // namespace
}  // namespace fovea::testing
