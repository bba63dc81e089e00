#include "core/detector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <opencv2/core.hpp>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/types/helpers.h"
#include "tests/core/tabletop.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea {
namespace {

using scenes::Tabletop;
using scenes::TabletopTruth;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

bool SameBits(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

void ExpectSame(const std::vector<Grasp>& a, const std::vector<Grasp>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].tool_center_point, b[i].tool_center_point);
    EXPECT_EQ(a[i].approach, b[i].approach);
    EXPECT_EQ(a[i].closing, b[i].closing);
    EXPECT_EQ(a[i].probability, b[i].probability);
  }
}

void ExpectSame(const Detections& a, const Detections& b) {
  EXPECT_TRUE(SameBits(a.labels, b.labels));
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].box.center, b.objects[i].box.center);
    EXPECT_EQ(a.objects[i].box.rotation, b.objects[i].box.rotation);
    EXPECT_EQ(a.objects[i].confidence, b.objects[i].confidence);
    EXPECT_EQ(a.objects[i].shape.kind, b.objects[i].shape.kind);
    ExpectSame(a.objects[i].grasps, b.objects[i].grasps);
  }
}

class Detector : public testing::TestWithParam<std::string> {
 protected:
  const DetectorOptions options_ = OptionsOfProfile(GetParam());
};

TEST_P(Detector, FindsObjectsOnATable) {
  const auto truth = TabletopTruth();
  const Detections found = Detect(truth.frame, options_);
  EXPECT_TRUE(found.support.has_value());
  EXPECT_GT(found.gravity.direction.dot(truth.gravity), 0.99F);
  EXPECT_FALSE(found.objects.empty());
  double max_label = 0;
  cv::minMaxLoc(found.labels, nullptr, &max_label);
  EXPECT_EQ(static_cast<std::size_t>(max_label), found.objects.size());
}

TEST_P(Detector, GivesTheSameBitsOnEveryRunAndThread) {
  const RgbdFrame frame = TabletopTruth().frame;
  const Detections first = Detect(frame, options_);
  EXPECT_FALSE(first.objects.empty());
  ExpectSame(first, Detect(frame, options_));
  Detections elsewhere;
  std::thread([&] { elsewhere = Detect(frame, options_); }).join();
  ExpectSame(first, elsewhere);
}

TEST_P(Detector, GivesTheSameBitsWithHelpers) {
  const RgbdFrame frame = TabletopTruth().frame;
  DetectorOptions options = options_;
  options.grippers.resize(2);
  options.grippers[1].hand = SuctionGripper();
  const Detections alone = Detect(frame, options);
  EXPECT_TRUE(std::any_of(alone.objects.begin(), alone.objects.end(),
                          [](const DetectedObject& object) { return !object.grasps.empty(); }));
  for (const int num_threads : {2, 3, 5}) {
    SCOPED_TRACE(num_threads);
    Helpers helpers(num_threads);
    const Helpers::Scope scope(helpers, num_threads);
    ExpectSame(alone, Detect(frame, options));
  }
}

TEST_P(Detector, TakesGravityAsGiven) {
  RgbdFrame frame = Tabletop();
  frame.gravity = Eigen::Vector3f(0.6F, 0.8F, 0.0F);
  const Detections found = Detect(frame, options_);
  EXPECT_TRUE(found.gravity.direction.isApprox(*frame.gravity, 1e-6F));
  EXPECT_EQ(found.gravity.source, Gravity::Source::kGiven);
}

TEST_P(Detector, SaysWhyAFrameWithoutDepthGivesNothing) {
  RgbdFrame frame = Tabletop();
  for (const float none : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity()}) {
    frame.depth_m.setTo(none);
    const Detections found = Detect(frame, options_);
    EXPECT_THAT(found.objects, SizeIs(0));
    EXPECT_THAT(found.diagnostics.messages, Contains(HasSubstr("no pixel has depth")));
  }
}

TEST_P(Detector, SaysWhyAFrameInTheWrongUnitGivesNothing) {
  RgbdFrame frame = Tabletop();
  frame.depth_m = frame.depth_m * 1000;
  EXPECT_THAT(Detect(frame, options_).diagnostics.messages, Contains(HasSubstr("depth unit")));
}

TEST_P(Detector, AcceptsTinyFlatAndNoisyFrames) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 7), cv::Size(9, 1), cv::Size(16, 16)}) {
    RgbdFrame frame{cv::Mat(size, CV_8UC3, cv::Scalar(9, 9, 9)),
                    cv::Mat(size, CV_32FC1, cv::Scalar(1.0F)),
                    {500, 500, 0, 0},
                    std::nullopt};
    EXPECT_THAT(Detect(frame, options_).objects, SizeIs(0)) << size;
  }
  const unsigned seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  cv::RNG random(seed);
  RgbdFrame noise{cv::Mat(120, 160, CV_8UC3), cv::Mat(120, 160, CV_32FC1), {130, 130, 80, 60}, {}};
  random.fill(noise.color_rgb, cv::RNG::UNIFORM, 0, 256);
  random.fill(noise.depth_m, cv::RNG::UNIFORM, -1, 70);
  EXPECT_NO_THROW(Detect(noise, options_));
}

TEST_P(Detector, ReportsStagesAndTrace) {
  Trace trace;
  const RgbdFrame frame = Tabletop();
  const Detections found = Detect(frame, options_, &trace);
  EXPECT_EQ(found.stage_times.front().stage, "depth");
  EXPECT_EQ(found.stage_times.back().stage, "objects");
  EXPECT_EQ(trace.seeds.size(), found.diagnostics.num_seeds);
  for (const cv::Mat& map : {trace.color_saliency, trace.depth_saliency}) {
    double low = 0;
    double high = 0;
    cv::minMaxLoc(map, &low, &high);
    EXPECT_EQ(map.size(), frame.depth_m.size());
    EXPECT_GE(low, 0);
    EXPECT_LE(high, 1);
  }
}

TEST_P(Detector, StopsBetweenStages) {
  int asked = 0;
  try {
    Detect(Tabletop(), options_, nullptr, [&] { return ++asked == 3; });
    FAIL() << "was not stopped";
  } catch (const Cancelled& cancelled) {
    EXPECT_EQ(asked, 3);
    ASSERT_FALSE(cancelled.stage_times.empty());
    EXPECT_EQ(cancelled.stage_times.front().stage, "depth");
    EXPECT_EQ(cancelled.stage_times.back().stage, cancelled.stage);
  }
}

TEST_P(Detector, AnswersWithWhatItHasWhenItsTimeEnds) {
  DetectorOptions options = options_;
  options.time_budget = std::chrono::nanoseconds(1);
  RgbdFrame frame = Tabletop();
  const Detections found = Detect(frame, options);
  EXPECT_TRUE(found.incomplete);
  EXPECT_TRUE(found.objects.empty());
  EXPECT_EQ(found.labels.size(), frame.depth_m.size());
  EXPECT_THAT(found.diagnostics.messages, testing::ElementsAre(HasSubstr("time budget ended")));
  EXPECT_FALSE(found.stage_times.empty());
  EXPECT_EQ(found.gravity.source, Gravity::Source::kAssumed);
  frame.gravity = Eigen::Vector3f(0.6F, 0.8F, 0.0F);
  const Gravity given = Detect(frame, options).gravity;
  EXPECT_TRUE(given.direction.isApprox(*frame.gravity, 1e-6F));
  EXPECT_EQ(given.source, Gravity::Source::kGiven);
}

TEST_P(Detector, FindsTheSameObjectsWithTimeToSpare) {
  const RgbdFrame frame = TabletopTruth().frame;
  const Detections without = Detect(frame, options_);
  DetectorOptions options = options_;
  options.time_budget = std::chrono::hours(1);
  const Detections within = Detect(frame, options);
  EXPECT_FALSE(within.incomplete);
  EXPECT_EQ(within.objects.size(), without.objects.size());
  std::vector<std::string> stages;
  for (const StageTime& time : within.stage_times) stages.push_back(time.stage);
  EXPECT_EQ(std::set<std::string>(stages.begin(), stages.end()).size(), stages.size());
}

TEST_P(Detector, IsStoppedByItsCallerAlsoWithTimeToSpare) {
  DetectorOptions options = options_;
  options.time_budget = std::chrono::hours(1);
  EXPECT_THROW(Detect(Tabletop(), options, nullptr, [] { return true; }), Cancelled);
}

TEST_P(Detector, RefusesABudgetOutOfRange) {
  for (const double ms : {-1.0, 3.7e6, std::numeric_limits<double>::quiet_NaN()}) {
    DetectorOptions options = options_;
    options.time_budget = std::chrono::duration<double, std::milli>(ms);
    EXPECT_THROW(Detect(Tabletop(), options), std::invalid_argument) << ms;
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, Detector, testing::ValuesIn(ProfileNames()),
                         [](const auto& profile) { return profile.param; });

TEST(Detect, NamesWhatIsWrongWithAFrame) {
  RgbdFrame frame = Tabletop();
  frame.intrinsics.fx_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { Detect(frame, {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("intrinsics.fx: ")));
  frame.intrinsics.fx_px = 2e6;
  EXPECT_THAT([&] { Detect(frame, {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("intrinsics.fx: 2e+06 is more than")));
  frame = Tabletop();
  frame.depth_m = frame.depth_m.rowRange(0, 100);
  EXPECT_THAT([&] { Detect(frame, {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("registered")));
}

}  // namespace
}  // namespace fovea
