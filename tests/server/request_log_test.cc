// Statistics, server information and the log of requests, after real calls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <semaphore>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "server/build_info.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/few_calls.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

TEST(Statistics, CountWhatWasDone) {
  const Loopback loopback(FindOne);
  DetectTwiceOnceBadly(loopback);
  const v1::GetStatisticsResponse statistics = loopback.client.GetStatistics();
  EXPECT_EQ(statistics.frames_received(), 2U);
  EXPECT_THAT(statistics.frames_answered(),
              UnorderedElementsAre(Pair("OK", 1), Pair("INVALID_ARGUMENT", 1)));
  EXPECT_EQ(statistics.objects(), 1U);
  EXPECT_EQ(statistics.received_bytes(), TestRequest().ByteSizeLong());
  EXPECT_GT(statistics.sent_bytes(), 0U);
  EXPECT_THAT(statistics.stages(), UnorderedElementsAre(Key("queue"), Key("decode"), Key("first"),
                                                        Key("processor_wait")));
  EXPECT_EQ(statistics.stages().at("first").count(), 1U);
  EXPECT_EQ(statistics.stages().at("first").total().nanos(), 1'500'000);
}

TEST(ServerInfo, TellsTheLimits) {
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 3;
  options.max_pixels = 1000;
  const Loopback loopback(FindOne, options);
  const v1::GetServerInfoResponse info = loopback.client.GetServerInfo();
  EXPECT_THAT(info.version(), ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_EQ(info.build(), server::Commit());
  EXPECT_THAT(info.profiles(), ElementsAre("default", "paper"));
  EXPECT_EQ(info.max_message_bytes(), 24U << 20);
  EXPECT_EQ(info.max_pixels(), 1000U);
  EXPECT_EQ(info.compute_threads(), 3U);
  EXPECT_EQ(info.max_waiting(), 3U);
  EXPECT_EQ(info.max_per_robot(), 4U);
}

TEST(RequestLog, NamesRequestRobotAndFrame) {
  const CapturedLog log;
  {
    const Loopback loopback(FindOne);
    DetectTwiceOnceBadly(loopback);
  }
  EXPECT_THAT(
      log.text(),
      ::testing::ContainsRegex(
          "request=\"[0-9]+\" robot=\"ipv4:127.0.0.1\" frame=\"frame-7\" code=OK objects=1"));
  EXPECT_THAT(log.text(), HasSubstr("code=INVALID_ARGUMENT"));
  EXPECT_THAT(log.text(), HasSubstr("error=\"frame: is missing\""));
  EXPECT_THAT(log.text(), Not(HasSubstr("slow ")));
}

TEST(RequestLog, NamesStreamsThatWereNotLetIn) {
  const CapturedLog log;
  {
    const Loopback loopback(FindOne);
    client::ClientOptions nameless = PatientOptions();
    nameless.robot = std::string(65, 'x');
    const client::Client client(loopback.server.Address(), nameless);
    StatusOf([&] { client.OpenStream(kPatience)->Receive(); });
  }
  EXPECT_THAT(log.text(), HasSubstr("stream request="));
  EXPECT_THAT(log.text(), HasSubstr("code=INVALID_ARGUMENT peer=\"ipv4:127.0.0.1:"));
  EXPECT_THAT(log.text(), HasSubstr(" error=\"metadata fovea-robot: must be"));
}

TEST(RequestLog, NamesTheLimitThatAMessageMayHavePassed) {
  const CapturedLog log;
  {
    server::ServerOptions options = LoopbackOptions();
    options.max_message_mib = 1;
    const Loopback loopback(FindOne, options);
    v1::DetectRequest request = TestRequest();
    request.mutable_frame()->mutable_color()->set_data(std::string(2 << 20, 'x'));
    StatusOf([&] { loopback.client.Detect(request); });
  }
  EXPECT_THAT(log.text(), HasSubstr("or it is larger than --max-message-mib"));
}

TEST(RequestLog, NamesTheStagesOfSlowFrames) {
  const CapturedLog log;
  {
    server::ServerOptions options = LoopbackOptions();
    options.slow_ms = 1;
    Gate gate;
    const Loopback loopback(std::ref(gate), options);
    std::jthread late([&] {
      gate.WaitUntilBegun();
      const auto begun = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begun <
             5 * std::chrono::milliseconds(options.slow_ms)) {
        std::this_thread::yield();
      }
      gate.Let();
    });
    loopback.client.Detect(TestRequest());
  }
  EXPECT_THAT(log.text(), HasSubstr("slow request="));
  EXPECT_THAT(log.text(), HasSubstr(" first_ms=1.5"));
}

// Of two calls that the server cancels the second one waits, and is not decoded.
TEST(RequestLog, SaysOfSlowFramesWhatIsKnown) {
  const CapturedLog log;
  server::ServerOptions options = LoopbackOptions();
  options.slow_ms = options.compute_threads = 1;
  options.max_per_robot = 2;
  options.drain_timeout_s = 0;
  {
    std::binary_semaphore begun{0};
    Loopback loopback(
        [&](const RgbdFrame&, const DetectorOptions&, Trace*, const auto& stop) -> Detections {
          begun.release();
          while (!stop()) std::this_thread::yield();
          throw Cancelled();
        },
        options);
    const auto call = [&] {
      return std::async(std::launch::async, [&] { return StatusOfDetecting(loopback.client); });
    };
    const auto first = call();
    begun.acquire();
    const auto second = call();
    AwaitMetric(*loopback.server.metrics(), "fovea_frames_waiting", 1);
    const auto since = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - since < std::chrono::milliseconds(5)) {
      std::this_thread::yield();
    }
    loopback.server.Drain();
  }
  std::istringstream lines(log.text());
  int num_slow = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("slow request=") == std::string::npos) continue;
    ++num_slow;
    EXPECT_THAT(line, HasSubstr(" queue_ms="));
    EXPECT_THAT(line, Not(HasSubstr("image=\"0x0\"")));
  }
  EXPECT_EQ(num_slow, 2);
}

TEST(RequestLog, IsNotWrittenByCallers) {
  const CapturedLog log;
  {
    const Loopback loopback(FindOne);
    v1::DetectRequest request = TestRequest();
    request.mutable_frame()->set_id("a\" code=OK\nforged");
    loopback.client.Detect(request);
  }
  EXPECT_THAT(log.text(), HasSubstr("frame=\"a? code=OK?forged\""));
}

}  // namespace
}  // namespace fovea::testing
