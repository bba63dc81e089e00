// Metrics, statistics, server information and logs, after real calls.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <unistd.h>

#include <sstream>
#include <string>

#include "server/watching/metrics_endpoint.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

// The answer to a GET of HTTP/1.0, which ends with the connection.
std::string HttpGet(const std::string& address, const std::string& path) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_EQ(connect(connection, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  const std::string request = "GET " + path + " HTTP/1.0\r\n\r\n";
  EXPECT_EQ(write(connection, request.data(), request.size()),
            static_cast<ssize_t>(request.size()));
  std::string answer;
  char buffer[4096];
  for (ssize_t size; (size = read(connection, buffer, sizeof buffer)) > 0;) {
    answer.append(buffer, static_cast<std::size_t>(size));
  }
  close(connection);
  return answer;
}

void DetectTwiceOnceBadly(const Loopback& loopback) {
  loopback.client.Detect(TestRequest());
  StatusOf([&] { loopback.client.Detect({}); });
}

TEST(Metrics, AreServedOverHttp) {
  const Loopback loopback(FindOne);
  const server::MetricsEndpoint endpoint("127.0.0.1:0", loopback.server.metrics());
  DetectTwiceOnceBadly(loopback);
  const std::string page = HttpGet(endpoint.Address(), "/metrics");
  EXPECT_THAT(page, HasSubstr("fovea_frames_received_total{robot=\"ipv4:127.0.0.1\"} 2"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_answered_total{code=\"OK\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_answered_total{code=\"INVALID_ARGUMENT\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_objects_total 1"));
  EXPECT_THAT(page, HasSubstr("fovea_stage_seconds_count{stage=\"decode\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_waiting 0"));
}

TEST(Metrics, SayWhereTheyCannotBeServed) {
  const Loopback loopback(FindOne);
  const server::MetricsEndpoint first("127.0.0.1:0", loopback.server.metrics());
  EXPECT_THAT([&] { server::MetricsEndpoint(first.Address(), loopback.server.metrics()); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("--metrics-listen: cannot listen on " + first.Address())));
}

TEST(Metrics, DoNotGrowWithNamesThatCallersInvent) {
  server::Metrics metrics([] { return 0; });
  for (int i = 0; i < 200; ++i) metrics.OnReceived("robot" + std::to_string(i));
  for (const auto& family : metrics.Collect()) {
    if (family.name != "fovea_frames_received_total") continue;
    EXPECT_EQ(family.metric.size(), 65U);
    double sum = 0;
    for (const auto& metric : family.metric) sum += metric.counter.value;
    EXPECT_EQ(sum, 200);
  }
}

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
  EXPECT_THAT(statistics.stages(), UnorderedElementsAre(Key("queue"), Key("decode"), Key("first")));
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
  EXPECT_THAT(info.profiles(), ElementsAre("default", "paper"));
  EXPECT_EQ(info.max_message_bytes(), 16U << 20);
  EXPECT_EQ(info.max_pixels(), 1000U);
  EXPECT_EQ(info.compute_threads(), 3U);
  EXPECT_EQ(info.max_waiting(), 3U);
  EXPECT_EQ(info.max_per_robot(), 4U);
}

// What is logged while it lives.
class CapturedLog {
 public:
  CapturedLog() : before_(spdlog::default_logger()) {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(
        "captured", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  ~CapturedLog() { spdlog::set_default_logger(before_); }

  std::string text() const { return text_.str(); }

 private:
  const std::shared_ptr<spdlog::logger> before_;
  std::ostringstream text_;
};

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
  EXPECT_THAT(log.text(), HasSubstr("code=INVALID_ARGUMENT error=\"metadata fovea-robot: must be"));
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
