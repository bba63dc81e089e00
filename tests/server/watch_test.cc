// Watching over real connections: who may, what comes, what is kept from whom.
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "client/client.h"
#include "fovea/v1/observation_service.grpc.pb.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/server/observers.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// One call of Watch.
class Watching {
 public:
  Watching(const std::string& address, const std::string& token,
           const v1::WatchRequest& request = {})
      : stub_(v1::ObservationService::NewStub(
            grpc::CreateChannel(address, grpc::InsecureChannelCredentials()))) {
    context_.set_deadline(std::chrono::system_clock::now() + kPatience);
    if (!token.empty()) context_.AddMetadata("authorization", "Bearer " + token);
    reader_ = stub_->Watch(&context_, request);
  }
  ~Watching() { context_.TryCancel(); }

  // The next message; an empty one at the end.
  v1::WatchResponse Next() {
    v1::WatchResponse response;
    if (!reader_->Read(&response)) return {};
    return response;
  }
  grpc::Status Finish() {
    while (reader_->Read(&ignored_)) {
    }
    return reader_->Finish();
  }

 private:
  std::unique_ptr<v1::ObservationService::Stub> stub_;
  grpc::ClientContext context_;
  std::unique_ptr<grpc::ClientReader<v1::WatchResponse>> reader_;
  v1::WatchResponse ignored_;
};

v1::WatchRequest RequestOf(const std::vector<v1::WatchPart>& parts, double rate_hz = 30) {
  v1::WatchRequest request;
  request.set_max_rate_hz(rate_hz);
  for (const v1::WatchPart part : parts) request.add_parts(part);
  return request;
}

std::string Gunzip(const std::string& file, std::size_t num_bytes) {
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  std::string bytes(num_bytes + 1, '\0');
  std::string input = file;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

TEST_F(Observers, AreToldWhoTheyAre) {
  const Loopback loopback(FindOne, options_);
  Watching watching(loopback.server.Address(), "kitchens");
  const v1::Observer observer = watching.Next().observer();
  EXPECT_EQ(observer.name(), "ben");
  EXPECT_THAT(observer.robots(), ElementsAre("kitchen-*", "hall"));
  EXPECT_THAT(observer.rights(), ElementsAre(v1::OBSERVER_RIGHT_VIEW));
  EXPECT_FALSE(observer.has_expires());
  EXPECT_FALSE(observer.server_version().empty());
}

TEST_F(Observers, SeeWhatTheRobotsAreAnswered) {
  const Loopback loopback(FindOne, options_);
  Watching watching(
      loopback.server.Address(), "all-of-it",
      RequestOf({v1::WATCH_PART_ANSWER, v1::WATCH_PART_PREVIEW, v1::WATCH_PART_PICTURE,
                 v1::WATCH_PART_DEPTH, v1::WATCH_PART_FRAME}));
  watching.Next();
  Detect(loopback, "attic");
  const v1::WatchedFrame frame = watching.Next().frame();
  EXPECT_EQ(frame.robot(), "attic");
  EXPECT_EQ(frame.frame_id(), TestFrame().id());
  EXPECT_EQ(frame.num_objects(), 1U);
  ASSERT_EQ(frame.detections().objects_size(), 1);
  EXPECT_GT(frame.detections().objects(0).mask().runs_size(), 0);  // the robot did not ask for it
  EXPECT_GT(frame.detections().stage_times_size(), 0);
  EXPECT_THAT(frame.preview(), StartsWith("\xFF\xD8"));
  EXPECT_THAT(frame.picture(), StartsWith("\xFF\xD8"));
  EXPECT_EQ(frame.frame().SerializeAsString(), TestFrame().SerializeAsString());
  const v1::WatchedDepth& depth = frame.depth();
  EXPECT_EQ(depth.unit_m(), 0.001);
  EXPECT_EQ(depth.intrinsics().fx(), TestFrame().intrinsics().fx());
  EXPECT_EQ(Gunzip(depth.data(), kDepthBytes), BytesOf(TestDepth()));
}

TEST_F(Observers, GetOnlyThePartsTheyAskFor) {
  const Loopback loopback(FindOne, options_);
  Watching watching(loopback.server.Address(), "all-of-it", RequestOf({}));
  watching.Next();
  Detect(loopback, "attic");
  const v1::WatchedFrame frame = watching.Next().frame();
  EXPECT_EQ(frame.num_objects(), 1U);
  EXPECT_THAT(frame.detections().objects(), IsEmpty());
  EXPECT_TRUE(frame.preview().empty() && frame.picture().empty());
  EXPECT_FALSE(frame.has_depth() || frame.has_frame());
}

TEST_F(Observers, SeeTheirRobotsAlone) {
  const Loopback loopback(FindOne, options_);
  Watching all(loopback.server.Address(), "all-of-it", RequestOf({}));
  Watching some(loopback.server.Address(), "kitchens", RequestOf({}));
  v1::WatchRequest foreign = RequestOf({});
  foreign.add_robots("attic");
  foreign.add_robots("hall");
  Watching reaching(loopback.server.Address(), "kitchens", foreign);
  for (Watching* each : {&all, &some, &reaching}) each->Next();
  for (const char* robot : {"attic", "kitchen-1", "kitchen", "hall"}) Detect(loopback, robot);
  for (const char* robot : {"attic", "kitchen-1", "kitchen", "hall"}) {
    EXPECT_EQ(all.Next().frame().robot(), robot);
  }
  EXPECT_EQ(some.Next().frame().robot(), "kitchen-1");
  EXPECT_EQ(some.Next().frame().robot(), "hall");
  EXPECT_EQ(reaching.Next().frame().robot(), "hall");
}

// Certificates have such names, and each character may be escaped.
TEST_F(Observers, LookAtRobotsOfLongNames) {
  const Loopback loopback(FindOne, options_);
  v1::WatchRequest request = RequestOf({});
  std::string pattern;
  for (int i = 0; i < 253; ++i) pattern += "\\*";
  request.add_robots(pattern);
  Watching watching(loopback.server.Address(), "all-of-it", request);
  EXPECT_TRUE(watching.Next().has_observer());
}

TEST_F(Observers, SeeRefusedFrames) {
  const Loopback loopback(FindOne, options_);
  v1::WatchRequest problems = RequestOf({v1::WATCH_PART_PREVIEW});
  problems.set_only_problems(true);
  Watching watching(loopback.server.Address(), "all-of-it", problems);
  watching.Next();
  Detect(loopback, "attic");
  v1::DetectRequest bad = TestRequest();
  bad.mutable_frame()->mutable_depth()->set_data("short");
  StatusOf([&] { Detect(loopback, "hall", bad); });
  const v1::WatchedFrame frame = watching.Next().frame();
  EXPECT_EQ(frame.robot(), "hall");
  EXPECT_TRUE(frame.is_problem());
  EXPECT_EQ(frame.error().code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(frame.error().field(), "frame.depth.data");
  EXPECT_TRUE(frame.preview().empty());
}

TEST_F(Observers, AreToldWhatTheyDidNotSee) {
  const Loopback loopback(FindOne, options_);
  Watching seldom(loopback.server.Address(), "all-of-it", RequestOf({}, 0.001));
  Watching often(loopback.server.Address(), "all-of-it", RequestOf({}, 30));
  seldom.Next();
  often.Next();
  std::uint64_t seen = 0, dropped = 0;
  constexpr std::uint64_t kFrames = 5;
  Detect(loopback, "attic");
  EXPECT_EQ(seldom.Next().frame().sequence(), 1U);
  for (std::uint64_t i = 1; i < kFrames; ++i) Detect(loopback, "attic");
  while (seen + dropped < kFrames) {  // the last one is shown, sooner or later
    const v1::WatchResponse response = often.Next();
    ++seen;
    dropped += response.dropped();
    EXPECT_EQ(response.frame().sequence(), seen + dropped);
  }
}

TEST_F(Observers, SeeEveryRobotHoweverManyThereAre) {
  constexpr std::size_t kRobots = 200;
  const Loopback loopback(FindOne, options_);
  Watching seldom(loopback.server.Address(), "all-of-it", RequestOf({}, 0.001));
  Watching often(loopback.server.Address(), "all-of-it", RequestOf({}));
  seldom.Next();
  often.Next();
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < kRobots; ++i) Detect(loopback, "robot-" + std::to_string(i));
  }
  std::map<std::string, std::uint64_t> shown;
  while (shown.size() < kRobots) {
    const v1::WatchedFrame frame = often.Next().frame();
    EXPECT_GT(frame.sequence(), shown[frame.robot()]) << frame.robot();
    shown[frame.robot()] = frame.sequence();
  }
  std::set<std::string> once;
  while (once.size() < kRobots) {
    const v1::WatchedFrame frame = seldom.Next().frame();
    EXPECT_TRUE(once.insert(frame.robot()).second) << frame.robot() << " came too soon again";
  }
}

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
      {"ann", ":1: \"\": is not a SHA-256"},
      {"# fine\nann " + hash + " look *", ":2: \"look\": is no right"},
      {"ann " + hash + " try *", ":1: \"try\": must have view"},
      {"ann " + hash + " view", ":1: \"\": must be 1 to 64 patterns"},
      {"ann " + hash + " view a,,b", ":1: \"a,,b\": must be 1 to 64 patterns"},
      {"ann " + hash + " view * soon", ":1: \"soon\": is not a time"},
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
