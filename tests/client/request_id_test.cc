// By what operators find the requests of robots in the log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "client/client.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::client {
namespace {

using ::testing::EndsWith;
using testing::kPatience;
using testing::Loopback;
using ::testing::ThrowsMessage;

template <typename Call>
RpcError ErrorFrom(Call&& call) {
  try {
    call();
  } catch (const RpcError& error) {
    return error;
  }
  throw std::logic_error("the call succeeded");
}

TEST(RequestId, OfTheCallersChoiceStandsInLogAndError) {
  const Loopback loopback(testing::FindOne);
  const testing::CapturedLog log;
  const RpcError error =
      ErrorFrom([&] { loopback.client.Detect({}, {.request_id = "pick of 17"}); });
  EXPECT_EQ(error.request_id(), "pick of 17");
  EXPECT_STREQ(error.what(), "INVALID_ARGUMENT: frame: is missing (request pick of 17)");
  EXPECT_EQ(error.message(), "frame: is missing");
  log.Await("request=\"pick of 17\" robot=\"ipv4:127.0.0.1\" frame=\"\" code=INVALID_ARGUMENT");
  loopback.client.Detect(testing::TestRequest(), kPatience, {.request_id = "place"});
  log.Await("request=\"place\"");
}

TEST(RequestId, ThatTheServerMadeUpStandsInTheError) {
  const Loopback loopback;
  const testing::CapturedLog log;
  const RpcError error = ErrorFrom([&] { loopback.client.Detect({}); });
  EXPECT_GT(std::stoi(error.request_id()), 0);
  EXPECT_THAT(error.what(), EndsWith("(request " + error.request_id() + ")"));
  log.Await("request=\"" + error.request_id() + "\" ");
}

TEST(RequestId, IsThatOfAllFramesOfAStream) {
  const Loopback loopback(testing::FindOne);
  const testing::CapturedLog log;
  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  request.mutable_frame()->set_id("f1");
  const auto stream = loopback.client.OpenStream(kPatience, {.request_id = "stream-1"});
  const auto resuming = loopback.client.OpenResumingStream(kPatience, {.request_id = "stream-2"});
  stream->Send(request);
  resuming->Send(request);
  log.Await("request=\"stream-1\" robot=\"ipv4:127.0.0.1\" frame=\"f1\"");
  log.Await("request=\"stream-2\" robot=\"ipv4:127.0.0.1\" frame=\"f1\"");
  resuming->Cancel();
  EXPECT_EQ(ErrorFrom([&] {
              while (resuming->Receive()) continue;
            }).request_id(),
            "stream-2");
}

// The server's metadata say it at the end of the stream, which may be days later.
TEST(RequestId, ThatTheServerMadeUpStandsInErrorsOfAStreamsFrames) {
  const Loopback loopback;
  const testing::CapturedLog log;
  const auto stream = loopback.client.OpenStream(kPatience);
  stream->Send({});
  const auto answer = stream->Receive();
  ASSERT_TRUE(answer && answer->has_error());
  EXPECT_GT(std::stoi(answer->error().request_id()), 0);
  log.Await("request=\"" + answer->error().request_id() + "\" ");
}

// Nobody says it back then.
TEST(RequestId, IsKnownWhereNoAnswerComesInTime) {
  const Loopback loopback;
  const auto in_time = std::chrono::milliseconds(0);
  const auto late = ErrorFrom(
      [&] { loopback.client.Detect(testing::TestRequest(), in_time, {.request_id = "late"}); });
  EXPECT_EQ(late.code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_EQ(late.request_id(), "late");
}

TEST(RequestId, IsRefusedWhereItCannotTravel) {
  const Loopback loopback;
  for (const char* text : {"k\u00fcche", "a\tb", "a\n"}) {
    EXPECT_THROW(loopback.client.Detect({}, {.request_id = text}), std::invalid_argument) << text;
    EXPECT_THROW(loopback.client.OpenStream(kPatience, {.request_id = text}),
                 std::invalid_argument);
    EXPECT_THROW(loopback.client.OpenResumingStream(kPatience, {.traceparent = text}),
                 std::invalid_argument);
  }
}

// The server's log would not have it, and the error would say that it does.
TEST(RequestId, IsRefusedWhereTheServerWouldRefuseIt) {
  const Loopback loopback(testing::FindOne);
  const CallOptions longest{.request_id = std::string(64, 'x')};
  const CallOptions too_long{.request_id = std::string(65, 'x')};
  const auto refused =
      ThrowsMessage<std::invalid_argument>("request_id: has 65 characters, more than 64");
  loopback.client.Detect(testing::TestRequest(), longest);
  EXPECT_THAT([&] { loopback.client.Detect({}, too_long); }, refused);
  EXPECT_THAT([&] { loopback.client.OpenStream(kPatience, too_long); }, refused);
  EXPECT_THAT([&] { loopback.client.OpenResumingStream(kPatience, too_long); }, refused);
}

}  // namespace
}  // namespace fovea::client
