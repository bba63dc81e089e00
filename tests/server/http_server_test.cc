// Metrics and probes over HTTP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "server/watching/metrics_endpoint.h"
#include "tests/server/detectors.h"
#include "tests/server/few_calls.h"
#include "tests/server/file_limit.h"
#include "tests/server/frames.h"
#include "tests/server/http_connection.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const server::Health kWell{.is_live = [] { return true; }, .is_ready = [] { return true; }};
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

TEST(HttpServer, TakesFewConnectionsWhereFewFilesMayBeOpen) {
  const std::size_t limit = NumOpenFiles() + 32;
  const std::size_t most = std::max<std::size_t>(limit / 8, 4), many = most + 32;
  std::unique_ptr<server::HttpServer> server;
  {
    const FileLimit low(limit);
    server = std::make_unique<server::HttpServer>("--here", "127.0.0.1:0", Pong);
  }
  const std::size_t before = NumOpenFiles();
  std::vector<std::unique_ptr<HttpConnection>> silent;
  for (std::size_t i = 0; i < many; ++i) {
    silent.push_back(std::make_unique<HttpConnection>(server->Address()));
  }
  EXPECT_THAT(HttpGet(server->Address(), "/"), EndsWith("pong"));
  EXPECT_LE(NumOpenFiles(), before + many + most);
}

TEST(HttpServer, EndsRequestsWithoutEnd) {
  const server::HttpServer server("--here", "127.0.0.1:0", Pong);
  const HttpConnection connection(server.Address());
  connection.Send("GET / HTTP/1.1\r\n");
  while (connection.Send("X: " + std::string(1000, 'x') + "\r\n")) {
  }
  EXPECT_THAT(HttpGet(server.Address(), "/"), EndsWith("pong"));
}

}  // namespace
}  // namespace fovea::testing
