// Watching over real connections: what comes, and of which robots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <opencv2/core.hpp>
#include <set>
#include <string>

#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/observers.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

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
  EXPECT_EQ(frame.detections().grippers_source(), frame.answer().grippers_source());
  EXPECT_NE(frame.answer().grippers_source(), v1::GRIPPER_SOURCE_UNSPECIFIED);
  EXPECT_THAT(frame.preview(), StartsWith("\xFF\xD8"));
  EXPECT_THAT(frame.picture(), StartsWith("\xFF\xD8"));
  EXPECT_EQ(frame.frame().SerializeAsString(), TestFrame().SerializeAsString());
  const v1::WatchedDepth& depth = frame.depth();
  EXPECT_EQ(depth.unit_m(), 0.001);
  EXPECT_EQ(depth.intrinsics().fx(), TestFrame().intrinsics().fx());
  EXPECT_EQ(Gunzip(depth.data(), kDepthBytes), BytesOf(TestDepth()));
}

// What no camera measures, or none so far, is not measured to them, and the rest keeps its unit.
TEST_F(Observers, SeeDepthWhateverIsFarAway) {
  const Loopback loopback(FindOne, options_);
  Watching watching(loopback.server.Address(), "all-of-it", RequestOf({v1::WATCH_PART_DEPTH}));
  watching.Next();
  cv::Mat meters = TestMeters();
  meters.at<float>(0, 1) = std::numeric_limits<float>::max();
  meters.at<float>(0, 2) = 9000;
  meters.at<float>(0, 3) = -1;
  meters.at<float>(0, 4) = 90;
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_32FC1, BytesOf(meters), meters.cols, meters.rows);
  Detect(loopback, "attic", request);
  const v1::WatchedDepth depth = watching.Next().frame().depth();
  EXPECT_LT(depth.unit_m(), 0.0014);
  const std::string bytes = Gunzip(depth.data(), kDepthBytes);
  const auto at = [&](int row, int col) {
    std::uint16_t units = 0;
    std::memcpy(&units, bytes.data() + sizeof units * (row * meters.cols + col), sizeof units);
    return units * depth.unit_m();
  };
  for (const int col : {1, 2, 3}) EXPECT_EQ(at(0, col), 0) << col;
  EXPECT_NEAR(at(0, 4), 90, 0.001);
  EXPECT_NEAR(at(1, 1), meters.at<float>(1, 1), 0.001);
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

}  // namespace
}  // namespace fovea::testing
