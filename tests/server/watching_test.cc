// Metrics, statistics, server information and logs, after real calls.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "server/build_info.h"
#include "server/watching/metrics_endpoint.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;
using ::testing::Pair;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

class HttpConnection {
 public:
  explicit HttpConnection(const std::string& address) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  ~HttpConnection() { close(socket_); }

  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  // False once the other side is gone.
  bool Send(const std::string& text) const {
    return send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }

  // Until the other side ends the connection.
  std::string ReadAll() const {
    std::string answer;
    char buffer[4096];
    for (ssize_t size; (size = read(socket_, buffer, sizeof buffer)) > 0;) {
      answer.append(buffer, static_cast<std::size_t>(size));
    }
    return answer;
  }

 private:
  const int socket_ = socket(AF_INET, SOCK_STREAM, 0);
};

std::string HttpGet(const std::string& address, const std::string& path) {
  const HttpConnection connection(address);
  EXPECT_TRUE(connection.Send("GET " + path + " HTTP/1.0\r\n\r\n"));
  return connection.ReadAll();
}

const server::Health kWell{.is_live = [] { return true; }, .is_ready = [] { return true; }};

std::string LabelOf(const prometheus::ClientMetric& metric, const std::string& name) {
  for (const auto& label : metric.label) {
    if (label.name == name) return label.value;
  }
  return "";
}

void DetectTwiceOnceBadly(const Loopback& loopback) {
  loopback.client.Detect(TestRequest());
  StatusOf([&] { loopback.client.Detect({}); });
}

TEST(Metrics, AreServedOverHttp) {
  const Loopback loopback(FindOne);
  const server::MetricsEndpoint endpoint("127.0.0.1:0", loopback.server.metrics(), kWell);
  DetectTwiceOnceBadly(loopback);
  const std::string page = HttpGet(endpoint.Address(), "/metrics");
  EXPECT_THAT(page, HasSubstr("fovea_frames_received_total 2"));
  EXPECT_THAT(page, HasSubstr("fovea_robot_frames_received_total{robot=\"ipv4:127.0.0.1\"} 2"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_answered_total{code=\"OK\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_answered_total{code=\"INVALID_ARGUMENT\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_objects_total 1"));
  EXPECT_THAT(page, HasSubstr("fovea_stage_seconds_count{stage=\"decode\"} 1"));
  EXPECT_THAT(page, HasSubstr("fovea_answer_seconds_count 1"));
  EXPECT_THAT(page, HasSubstr("fovea_frames_waiting 0"));
  EXPECT_THAT(page, HasSubstr("fovea_busy_threads 0"));
  EXPECT_THAT(page, HasSubstr("fovea_build_info{"));
}

TEST(Metrics, SayWhereTheyCannotBeServed) {
  const Loopback loopback(FindOne);
  const server::MetricsEndpoint first("127.0.0.1:0", loopback.server.metrics(), kWell);
  EXPECT_THAT([&] { server::MetricsEndpoint(first.Address(), loopback.server.metrics(), kWell); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("--metrics-listen: cannot listen on " + first.Address())));
}

TEST(Probes, TellLifeFromReadiness) {
  const Loopback loopback(FindOne);
  bool live = true, ready = false;
  const server::MetricsEndpoint endpoint(
      "127.0.0.1:0", loopback.server.metrics(),
      {.is_live = [&] { return live; }, .is_ready = [&] { return ready; }});
  EXPECT_THAT(HttpGet(endpoint.Address(), "/livez?verbose"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(HttpGet(endpoint.Address(), "/readyz"), StartsWith("HTTP/1.1 503"));
  ready = true;
  live = false;
  EXPECT_THAT(HttpGet(endpoint.Address(), "/livez"), StartsWith("HTTP/1.1 503"));
  EXPECT_THAT(HttpGet(endpoint.Address(), "/readyz"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(HttpGet(endpoint.Address(), "/else"), StartsWith("HTTP/1.1 404"));
}

TEST(Probes, SeeThatTheServerStops) {
  Loopback loopback(FindOne);
  EXPECT_TRUE(loopback.server.IsServing());
  loopback.server.StopAdvertising();
  EXPECT_FALSE(loopback.server.IsServing());
}

server::HttpAnswer Pong(std::string_view) { return {.body = "pong"}; }

TEST(HttpServer, AnswersNothingButGet) {
  const server::HttpServer server("--here", "127.0.0.1:0", Pong);
  const HttpConnection connection(server.Address());
  connection.Send("POST / HTTP/1.1\r\nContent-Length: 0\r\n\r\n");
  EXPECT_THAT(connection.ReadAll(), StartsWith("HTTP/1.1 405"));
}

TEST(HttpServer, AnswersWhatIsThrown) {
  const server::HttpServer server("--here", "127.0.0.1:0", [](std::string_view) {
    throw std::runtime_error("a secret");
    return server::HttpAnswer{};
  });
  const std::string answer = HttpGet(server.Address(), "/");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 500"));
  EXPECT_THAT(answer, Not(HasSubstr("secret")));
}

TEST(HttpServer, AnswersBesideConnectionsThatSendNothingMore) {
  const server::HttpServer server("--here", "127.0.0.1:0", Pong);
  std::vector<std::unique_ptr<HttpConnection>> slow;
  for (int i = 0; i < 200; ++i) {
    slow.push_back(std::make_unique<HttpConnection>(server.Address()));
    slow.back()->Send("GET / HT");
  }
  EXPECT_THAT(HttpGet(server.Address(), "/"), EndsWith("pong"));
  // The oldest made room for the newest; those get an end as well.
  EXPECT_EQ(slow.front()->ReadAll(), "");
  EXPECT_EQ(slow.back()->ReadAll(), "");
}

TEST(HttpServer, EndsRequestsWithoutEnd) {
  const server::HttpServer server("--here", "127.0.0.1:0", Pong);
  const HttpConnection connection(server.Address());
  connection.Send("GET / HTTP/1.1\r\n");
  while (connection.Send("X: " + std::string(1000, 'x') + "\r\n")) {
  }
  EXPECT_THAT(HttpGet(server.Address(), "/"), EndsWith("pong"));
}

// The robots that have figures of their own.
std::set<std::string> Robots(const server::Metrics& metrics, const std::string& family_name) {
  std::set<std::string> robots;
  for (const auto& family : metrics.Collect()) {
    if (family.name != family_name) continue;
    for (const auto& metric : family.metric) robots.insert(LabelOf(metric, "robot"));
  }
  return robots;
}

TEST(Metrics, DoNotGrowWithNamesThatCallersInvent) {
  server::Metrics metrics(std::chrono::hours(1));  // none is gone
  for (int i = 0; i < 200; ++i) metrics.OnReceived("robot" + std::to_string(i));
  const auto robots = Robots(metrics, "fovea_robot_frames_received_total");
  EXPECT_EQ(robots.size(), 65U);
  EXPECT_TRUE(robots.contains("robot63"));
  EXPECT_TRUE(robots.contains("other"));
  EXPECT_EQ(MetricValue(metrics, "fovea_robot_frames_received_total"), 200);
}

TEST(Metrics, GiveTheRoomOfNamesThatAreGoneToNewOnes) {
  server::Metrics metrics(std::chrono::seconds(0));  // all others are gone at once
  metrics.OnReceived("late");
  for (int i = 0; i < 63; ++i) metrics.OnReceived("robot" + std::to_string(i));
  metrics.OnRefused("late", "QUEUE_FULL");  // heard of after robot0
  metrics.OnAnswered("robot0", grpc::Status::OK, {}, std::chrono::seconds(1));
  metrics.OnReceived("new");  // takes the place of robot1
  metrics.OnReceived("other");
  const auto robots = Robots(metrics, "fovea_robot_frames_received_total");
  EXPECT_EQ(robots.size(), 65U);
  for (const char* name : {"late", "robot0", "new", "other"}) EXPECT_TRUE(robots.contains(name));
  EXPECT_FALSE(robots.contains("robot1"));
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_received_total"), 66);
  for (int i = 0; i < 64; ++i) metrics.OnReceived("another" + std::to_string(i));
  EXPECT_THAT(Robots(metrics, "fovea_robot_frames_answered_total"), IsEmpty());
  EXPECT_FALSE(Robots(metrics, "fovea_robot_refused_total").contains("late"));
  EXPECT_FALSE(Robots(metrics, "fovea_robot_answer_seconds").contains("robot0"));
}

TEST(Metrics, TellRobotsApart) {
  server::Metrics metrics;
  metrics.OnAnswered("a", grpc::Status::OK, {}, std::chrono::milliseconds(70));
  metrics.OnAnswered("b", {grpc::StatusCode::INTERNAL, ""}, {}, std::chrono::seconds(1));
  metrics.OnRefused("b", "ROBOT_LIMIT");
  metrics.OnRefused("", "UNAUTHENTICATED");  // nobody
  EXPECT_EQ(MetricValue(metrics, "fovea_refused_total"), 2);
  EXPECT_EQ(MetricValue(metrics, "fovea_robot_refused_total"), 1);
  EXPECT_EQ(MetricValue(metrics, "fovea_answer_seconds"), 1);
  EXPECT_EQ(MetricValue(metrics, "fovea_robot_answer_seconds"), 1);
  EXPECT_EQ(MetricValue(metrics, "fovea_robot_frames_answered_total"), 2);
  EXPECT_THAT(Robots(metrics, "fovea_robot_frames_answered_total"), ElementsAre("a", "b"));
}

TEST(Metrics, HoldLabelsThatAreText) {
  server::Metrics metrics;
  metrics.OnReceived("caf\xE9\n");
  EXPECT_THAT(Robots(metrics, "fovea_robot_frames_received_total"), ElementsAre("caf??"));
}

TEST(Metrics, ReadWhatOthersCount) {
  server::Metrics metrics;
  double open = 3;
  metrics.AddGauge("fovea_open_doors", "Doors", [&] { return open; });
  metrics.AddCounter("fovea_knocks_total", "Knocks", [] { return 7; });
  open = 4;
  EXPECT_EQ(MetricValue(metrics, "fovea_open_doors"), 4);
  EXPECT_EQ(MetricValue(metrics, "fovea_knocks_total"), 7);
}

TEST(Metrics, TellOfTheProcess) {
  const server::Metrics metrics;
  const double files = MetricValue(metrics, "process_open_fds");
  const int another = dup(STDERR_FILENO);
  EXPECT_EQ(MetricValue(metrics, "process_open_fds"), files + 1);
  close(another);
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  EXPECT_EQ(MetricValue(metrics, "process_max_fds"), static_cast<double>(limit.rlim_cur));
  EXPECT_GT(MetricValue(metrics, "process_resident_memory_bytes"), 1 << 20);
  EXPECT_GT(MetricValue(metrics, "process_cpu_seconds_total"), 0);
  const auto now =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch());
  EXPECT_LE(MetricValue(metrics, "process_start_time_seconds"), now.count() + 1);
  EXPECT_GT(MetricValue(metrics, "process_start_time_seconds"), now.count() - 24 * 3600);
}

TEST(Metrics, CountThreadsThatWork) {
  Gate gate;
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 3;
  const Loopback loopback(std::ref(gate), options);
  const server::Metrics& metrics = *loopback.server.metrics();
  EXPECT_EQ(MetricValue(metrics, "fovea_compute_threads"), 3);
  const std::jthread call([&] { loopback.client.Detect(TestRequest()); });
  gate.WaitUntilBegun();
  EXPECT_EQ(MetricValue(metrics, "fovea_busy_threads"), 1);
  gate.Let();
  AwaitMetric(metrics, "fovea_busy_threads", 0);
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
