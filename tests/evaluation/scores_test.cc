#include "tests/evaluation/scores.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

namespace fovea::evaluation {
namespace {

const cv::Size kSize(100, 100);  // boundary reach: ceil(0.003 · 141) = 1 px
const cv::Mat kAllValid = cv::Mat::ones(kSize, CV_8UC1);

cv::Mat Labels(const std::vector<cv::Rect>& objects) {
  cv::Mat labels = cv::Mat::zeros(kSize, CV_16UC1);
  for (std::size_t k = 0; k < objects.size(); ++k) labels(objects[k]).setTo(double(k + 1));
  return labels;
}

void ExpectScore(const Score& score, double precision, double recall, double f) {
  EXPECT_DOUBLE_EQ(score.precision, precision);
  EXPECT_DOUBLE_EQ(score.recall, recall);
  EXPECT_DOUBLE_EQ(score.f, f);
}

TEST(Scores, AreFullForTheTruthItselfWhateverItsNumbers) {
  const cv::Mat truth = Labels({{10, 10, 20, 20}, {40, 10, 20, 20}});
  cv::Mat renumbered = truth.clone();
  renumbered.setTo(7, truth == 1);
  const SceneScores scores = ScoreScene(truth, renumbered, kAllValid);
  EXPECT_EQ(scores.counts.truth, 2);
  EXPECT_EQ(scores.counts.predicted, 2);
  EXPECT_EQ(scores.counts.matched_boxes, 2);
  EXPECT_EQ(scores.counts.matched_75, 2);
  ExpectScore(scores.overlap, 1, 1, 1);
  ExpectScore(scores.boundary, 1, 1, 1);
}

TEST(Scores, CountTheSharedPixelsOfAMatchedPair) {
  // 200 of 400 predicted pixels lie in the 200 true ones.
  const SceneScores scores =
      ScoreScene(Labels({{10, 10, 10, 20}}), Labels({{10, 10, 20, 20}}), kAllValid);
  ExpectScore(scores.overlap, 0.5, 1, 2.0 / 3);
  EXPECT_EQ(scores.counts.matched_boxes, 0) << "an IoU of exactly 0.5 is not above 0.5";
  EXPECT_EQ(scores.counts.matched_75, 0);
}

TEST(Scores, GiveOnePredictionToOneObject) {
  // One prediction over two objects: 800 of its 800 pixels are true, 400 belong to its object.
  const SceneScores fused = ScoreScene(Labels({{10, 10, 20, 20}, {30, 10, 20, 20}}),
                                       Labels({{10, 10, 40, 20}}), kAllValid);
  ExpectScore(fused.overlap, 0.5, 0.5, 0.5);
  // One object in two parts.
  const SceneScores split = ScoreScene(Labels({{10, 10, 40, 20}}),
                                       Labels({{10, 10, 30, 20}, {40, 10, 10, 20}}), kAllValid);
  ExpectScore(split.overlap, 0.75, 0.75, 0.75);
  EXPECT_EQ(split.counts.matched_boxes, 1);
  EXPECT_EQ(split.box_matched, (std::map<int, bool>{{1, true}, {2, false}}));
  EXPECT_EQ(split.counts.matched_75, 1) << "F of the larger part is 2·600/1400";
}

// Objects of two pixels each, the corners of boxes from `top` to `bottom`.
cv::Mat Corners(const std::vector<cv::Vec2i>& rows) {
  cv::Mat labels = cv::Mat::zeros(kSize, CV_16UC1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    labels.at<std::uint16_t>(rows[k][0], 10) = static_cast<std::uint16_t>(k + 1);
    labels.at<std::uint16_t>(rows[k][1] - 1, 20) = static_cast<std::uint16_t>(k + 1);
  }
  return labels;
}

TEST(Scores, MatchAsManyBoxesAsPossible) {
  // The first prediction overlaps the first object most (0.76) and the second enough (0.67); the
  // second prediction overlaps only the first object (0.6). A greedy choice finds one pair.
  const cv::Mat truth = Corners({{15, 75}, {35, 95}}), prediction = Corners({{23, 83}, {0, 60}});
  EXPECT_EQ(ScoreScene(truth, prediction, kAllValid).counts.matched_boxes, 2);
}

TEST(Scores, LeaveOutPixelsWithoutDepth) {
  cv::Mat valid = kAllValid.clone();
  valid(cv::Rect(30, 0, 70, 100)).setTo(0);
  const SceneScores scores = ScoreScene(Labels({{10, 10, 20, 20}, {50, 50, 20, 20}}),
                                        Labels({{10, 10, 40, 20}, {80, 80, 5, 5}}), valid);
  EXPECT_EQ(scores.counts.truth, 1);
  EXPECT_EQ(scores.counts.predicted, 1);
  ExpectScore(scores.overlap, 1, 1, 1);
  ExpectScore(scores.boundary, 1, 1, 1);
}

TEST(Scores, OfBoundariesForgiveTheReach) {
  const cv::Mat truth = Labels({{20, 20, 30, 30}});
  ExpectScore(ScoreScene(truth, Labels({{21, 20, 30, 30}}), kAllValid).boundary, 1, 1, 1);
  ExpectScore(ScoreScene(truth, Labels({{10, 10, 50, 50}}), kAllValid).boundary, 0, 0, 0);
}

TEST(Scores, OfBoundariesCountByHand) {
  // Either boundary is the ring of an 11×11 square (40 pixels), two columns apart. Hits: ten
  // pixels of each horizontal edge, and the two of the inner vertical edge next to them.
  const SceneScores scores =
      ScoreScene(Labels({{20, 20, 10, 10}}), Labels({{22, 20, 10, 10}}), kAllValid);
  ExpectScore(scores.boundary, 22.0 / 40, 22.0 / 40, 22.0 / 40);
}

TEST(Scores, OfNothing) {
  const cv::Mat none = Labels({}), one = Labels({{10, 10, 20, 20}});
  const SceneScores missed = ScoreScene(one, none, kAllValid);
  ExpectScore(missed.overlap, 1, 0, 0);
  ExpectScore(missed.boundary, 1, 0, 0);
  const SceneScores invented = ScoreScene(none, one, kAllValid);
  ExpectScore(invented.overlap, 0, 1, 0);
  ExpectScore(invented.boundary, 0, 1, 0);
  const SceneScores agreed = ScoreScene(none, none, kAllValid);
  ExpectScore(agreed.overlap, 1, 1, 1);
  ExpectScore(agreed.boundary, 1, 1, 1);
}

}  // namespace
}  // namespace fovea::evaluation
