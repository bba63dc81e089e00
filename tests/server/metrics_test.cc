// What metrics count, after real calls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prometheus/text_serializer.h>
#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "client/rpc_error.h"
#include "server/access/token_line.h"
#include "server/build_info.h"
#include "server/scheduling/refusal_reasons.h"
#include "server/status.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using ::testing::UnorderedElementsAreArray;

std::string LabelOf(const prometheus::ClientMetric& metric, const std::string& name) {
  for (const auto& label : metric.label) {
    if (label.name == name) return label.value;
  }
  return "";
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

TEST(Metrics, TellRobotsApartWhateverTheirNamesAreMadeOf) {
  server::Metrics metrics;
  for (const char* name : {"küche", "kuche", "厨房", "浴室", "caf\xE9\n", "caf\xE8\n"}) {
    metrics.OnReceived(name);
  }
  EXPECT_THAT(
      Robots(metrics, "fovea_robot_frames_received_total"),
      UnorderedElementsAre("küche", "kuche", "厨房", "浴室", "caf\\xE9\\x0A", "caf\\xE8\\x0A"));
}

TEST(Metrics, HoldNamesAsTheTextFormatAsks) {
  server::Metrics metrics;
  metrics.OnReceived("a\"ü\\");
  EXPECT_THAT(prometheus::TextSerializer().Serialize(metrics.Collect()),
              HasSubstr(R"(fovea_robot_frames_received_total{robot="a\"ü\\"} 1)"));
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

// The values of a label that there are before anything happened.
std::vector<std::string> ValuesAtFirst(const std::string& family_name, const std::string& label) {
  std::vector<std::string> values;
  for (const auto& family : server::Metrics().Collect()) {
    if (family.name != family_name) continue;
    for (const auto& metric : family.metric) {
      EXPECT_EQ(metric.counter.value, 0);
      values.push_back(LabelOf(metric, label));
    }
  }
  return values;
}

TEST(Metrics, BeginWithZeroForWhateverMayHappen) {
  std::vector<std::string> codes;
  for (int code = 0; code <= grpc::StatusCode::UNAUTHENTICATED; ++code) {
    const auto status_code = static_cast<grpc::StatusCode>(code);
    const std::string text = client::RpcError({status_code, "why"}).what();
    codes.push_back(text.substr(0, text.find(':')));
    EXPECT_EQ(server::NameOf(status_code), codes.back());
  }
  EXPECT_THAT(ValuesAtFirst("fovea_frames_answered_total", "code"),
              UnorderedElementsAreArray(codes));
  EXPECT_THAT(ValuesAtFirst("fovea_refused_total", "reason"),
              UnorderedElementsAreArray(server::kRefusalReasons));
}

std::string PageOf(const std::string& name) {
  std::ifstream file(FOVEA_SOURCE_DIR "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Metrics, AreAllInTheDocumentation) {
  server::ServerOptions options = LoopbackOptions();
  options.trace_endpoint = "http://127.0.0.1:1/v1/traces";  // where nobody is
  const TemporaryFolder folder;
  options.observers = folder.Write("observers", "ann " + server::HashOfToken("all") + " view *\n");
  const Loopback loopback(FindOne, options);
  loopback.server.metrics()->OnReceived("arm");
  const std::string pages = PageOf("operations.md") + PageOf("observer.md");
  for (const auto& family : loopback.server.metrics()->Collect()) {
    if (family.name.starts_with("process_")) continue;
    EXPECT_THAT(pages, HasSubstr("`" + family.name + "`")) << "docs/operations.md misses it";
  }
  for (const char* reason : server::kRefusalReasons) {
    EXPECT_THAT(pages, HasSubstr("`" + std::string(reason) + "`"));
  }
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

}  // namespace
}  // namespace fovea::testing
