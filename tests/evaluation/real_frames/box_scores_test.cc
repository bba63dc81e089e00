#include "tests/evaluation/real_frames/box_scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace fovea::evaluation {
namespace {

BoxedFrame FrameWith(const std::vector<BoxedObject>& objects) {
  BoxedFrame frame{"source", "frame", {}, objects};
  frame.frame.depth_m = cv::Mat(100, 200, CV_32FC1, cv::Scalar(1));
  return frame;
}

cv::Mat LabelsOf(const std::vector<cv::Rect>& boxes) {
  cv::Mat labels = cv::Mat::zeros(100, 200, CV_16UC1);
  for (std::size_t i = 0; i < boxes.size(); ++i) labels(boxes[i]).setTo(i + 1);
  return labels;
}

TEST(BoxScores, CountRequiredObjectsAndLeaveOptionalOnesOut) {
  const BoxedFrame frame = FrameWith({{"cup", {10, 10, 20, 20}}, {"note", {60, 10, 20, 20}, true}});
  const BoxScores scores =
      ScoreBoxes(frame, LabelsOf({{60, 12, 20, 20}, {11, 10, 20, 20}, {120, 40, 30, 30}}));
  EXPECT_EQ(scores.required, 1);
  EXPECT_EQ(scores.found, 1);
  EXPECT_EQ(scores.wrong, 1);
  EXPECT_EQ(scores.judged, (std::map<int, bool>{{2, true}, {3, false}}));
  EXPECT_DOUBLE_EQ(scores.Boxes().precision, 0.5);
  EXPECT_DOUBLE_EQ(scores.Boxes().recall, 1);
}

TEST(BoxScores, MatchesRequiredObjectsFirstAndEachPredictionOnce) {
  const BoxedFrame frame = FrameWith({{"pair", {10, 10, 30, 20}, true}, {"cup", {10, 10, 22, 20}}});
  const BoxScores scores = ScoreBoxes(frame, LabelsOf({{10, 10, 28, 20}}));
  EXPECT_EQ(scores.found, 1);
  EXPECT_EQ(scores.wrong, 0);
}

TEST(BoxScores, NothingToFindAndNothingFoundIsPerfect) {
  EXPECT_DOUBLE_EQ(ScoreBoxes(FrameWith({}), LabelsOf({})).Boxes().f, 1);
  EXPECT_DOUBLE_EQ(ScoreBoxes(FrameWith({}), LabelsOf({{0, 0, 9, 9}})).Boxes().f, 0);
}

struct Case {
  Failure missed;
  Failure wrong;
  std::vector<cv::Rect> predictions;
};

class BoxFailures : public testing::TestWithParam<Case> {};

TEST_P(BoxFailures, AreNamed) {
  const BoxedFrame frame = FrameWith({{"cup", {20, 20, 40, 40}}, {"box", {60, 20, 40, 40}, true}});
  const BoxScores scores = ScoreBoxes(frame, LabelsOf(GetParam().predictions));
  EXPECT_EQ(scores.missed, (std::map<Failure, int>{{GetParam().missed, 1}}))
      << NameOf(scores.missed.begin()->first);
  const int count = static_cast<int>(GetParam().predictions.size());
  EXPECT_EQ(scores.wrong_by, (std::map<Failure, int>{{GetParam().wrong, count}}))
      << NameOf(scores.wrong_by.begin()->first);
}

INSTANTIATE_TEST_SUITE_P(
    , BoxFailures,
    testing::Values(Case{Failure::kMerged, Failure::kMerged, {{20, 20, 90, 40}}},
                    Case{Failure::kSplit, Failure::kPart, {{20, 20, 20, 40}, {41, 20, 19, 40}}},
                    Case{Failure::kPart, Failure::kPart, {{20, 20, 15, 40}}},
                    Case{Failure::kWithBackground, Failure::kWithBackground, {{0, 0, 60, 90}}},
                    Case{Failure::kNothing, Failure::kNothing, {{130, 20, 40, 40}}},
                    Case{Failure::kWrongExtent, Failure::kWrongExtent, {{4, 20, 24, 40}}}),
    [](const auto& test) {
      std::string name = NameOf(test.param.missed);
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

TEST(BoxScores, WhereThereIsNoDepthNothingCanBeReported) {
  BoxedFrame frame = FrameWith({{"glass", {20, 20, 40, 40}}});
  frame.frame.depth_m(frame.objects[0].box).setTo(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(ScoreBoxes(frame, LabelsOf({})).missed,
            (std::map<Failure, int>{{Failure::kNoDepth, 1}}));
}

}  // namespace
}  // namespace fovea::evaluation
