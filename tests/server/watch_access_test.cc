// Who may watch, and until when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/server/detectors.h"
#include "tests/server/metric_value.h"
#include "tests/server/observers.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(Observers, NeedTheirOwnToken) {
  options_.tokens = folder_.Write("tokens", "robot " + server::HashOfToken("of-a-robot") + "\n");
  const Loopback loopback(FindOne, options_);
  for (const char* token : {"", "of-a-robot", "ALL-OF-IT", "nonsense"}) {
    EXPECT_EQ(Watching(loopback.server.Address(), token).Finish().error_code(),
              grpc::StatusCode::UNAUTHENTICATED)
        << token;
  }
  client::ClientOptions observer = PatientOptions();
  observer.token = "all-of-it";
  const client::Client robot(loopback.server.Address(), observer);
  EXPECT_EQ(StatusOf([&] { robot.Detect(TestRequest()); }).error_code(),
            grpc::StatusCode::UNAUTHENTICATED);
}

TEST_F(Observers, MayNotDownloadWithoutTheRight) {
  const Loopback loopback(FindOne, options_);
  const grpc::Status status =
      Watching(loopback.server.Address(), "kitchens", RequestOf({v1::WATCH_PART_FRAME})).Finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::PERMISSION_DENIED);
  EXPECT_THAT(status.error_message(), HasSubstr("download"));
}

TEST_F(Observers, AreToldOfBadRequests) {
  const Loopback loopback(FindOne, options_);
  const auto error_of = [&](auto change) {
    v1::WatchRequest request;
    change(request);
    const grpc::Status status = Watching(loopback.server.Address(), "all-of-it", request).Finish();
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    return status.error_message();
  };
  EXPECT_THAT(error_of([](auto& r) { r.set_max_rate_hz(31); }), StartsWith("max_rate_hz: "));
  EXPECT_THAT(error_of([](auto& r) { r.set_max_rate_hz(-1); }), StartsWith("max_rate_hz: "));
  EXPECT_THAT(error_of([](auto& r) { r.set_max_rate_hz(NAN); }), StartsWith("max_rate_hz: "));
  EXPECT_THAT(error_of([](auto& r) { r.add_parts(v1::WatchPart{99}); }), StartsWith("parts: "));
  EXPECT_THAT(error_of([](auto& r) { r.add_robots(""); }), StartsWith("robots: "));
  EXPECT_THAT(error_of([](auto& r) {
                for (int i = 0; i < 65; ++i) r.add_robots("r");
              }),
              StartsWith("robots: "));
}

TEST_F(Observers, AreLetGoWhenTheirTokenIs) {
  Loopback loopback(FindOne, options_);
  Watching ann(loopback.server.Address(), "all-of-it", RequestOf({}));
  Watching ben(loopback.server.Address(), "kitchens", RequestOf({}));
  ann.Next();
  ben.Next();
  folder_.Write("observers", Line("ben", "kitchens", "view", "kitchen-*,hall"));
  loopback.server.ReloadAccess();
  EXPECT_EQ(ann.Finish().error_code(), grpc::StatusCode::UNAUTHENTICATED);
  Detect(loopback, "hall");
  EXPECT_EQ(ben.Next().frame().robot(), "hall");
}

TEST_F(Observers, DoNotKeepTheServerFromStopping) {
  auto loopback = std::make_unique<Loopback>(FindOne, options_);
  Watching watching(loopback->server.Address(), "all-of-it");
  watching.Next();
  loopback->server.Drain();
  EXPECT_EQ(watching.Finish().error_code(), grpc::StatusCode::UNAVAILABLE);
}

TEST_F(Observers, LeaveNothingBehind) {
  const Loopback loopback(FindOne, options_);
  const server::Metrics& metrics = *loopback.server.metrics();
  {
    Watching watching(loopback.server.Address(), "all-of-it", RequestOf({}, 0.001));
    watching.Next();
    EXPECT_EQ(MetricValue(metrics, "fovea_watchers"), 1);
    Detect(loopback, "attic");
    EXPECT_EQ(watching.Next().frame().sequence(), 1U);
    Detect(loopback, "attic");  // waits to be shown
    AwaitMetric(metrics, "fovea_frames_answered_total", 2);
    EXPECT_GT(MetricValue(metrics, "fovea_watch_waiting_bytes"), 0);
  }
  AwaitMetric(metrics, "fovea_watchers", 0);
  AwaitMetric(metrics, "fovea_watch_waiting_bytes", 0);
  Detect(loopback, "attic");  // nobody watches
  EXPECT_EQ(MetricValue(metrics, "fovea_watch_waiting_bytes"), 0);
}

TEST(NoObservers, NobodyWatches) {
  const Loopback loopback(FindOne);
  EXPECT_EQ(Watching(loopback.server.Address(), "any").Finish().error_code(),
            grpc::StatusCode::UNIMPLEMENTED);
}

TEST_F(Observers, FileMistakesAreNamed) {
  const std::string hash = server::HashOfToken("x");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"ann", ":1: the hash: is not a SHA-256"},
      {"# fine\nann " + hash + " look *", ":2: \"look\": is no right"},
      {"ann " + hash + " try *", ":1: \"try\": must have view"},
      {"ann " + hash + " view", ":1: \"\": must be 1 to 64 patterns"},
      {"ann " + hash + " view a,,b", ":1: \"a,,b\": must be 1 to 64 patterns"},
      {"ann " + hash + " view * soon", ":1: when it expires: is not a time"},
      {"\xFC " + hash + " view *", ":1: the name: is no UTF-8"},
      {"ann " + hash + " view k\xFC,hall", ":1: \"k?,hall\": is no UTF-8"},
      {"ann " + hash + " view *\nben " + hash + " view *", ":2: the token: is there twice"}};
  for (const auto& [text, error] : cases) {
    options_.observers = folder_.Write("bad", text);
    EXPECT_THAT([&] { const server::Server server(options_, FindOne); },
                ::testing::ThrowsMessage<std::invalid_argument>(
                    StartsWith("--observers: " + options_.observers + error)));
  }
}

}  // namespace
}  // namespace fovea::testing
