#include "tests/evaluation/peers/peer.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

#include "tests/evaluation/dataset.h"
#include "tests/evaluation/peers/table_removal.h"
#include "tests/evaluation/scores.h"
#include "tests/support/data_path.h"

namespace fovea::evaluation {
namespace {

const CameraIntrinsics kIntrinsics = {525, 525, 319.5, 239.5};

// A wall at 1 m that faces the camera, and two plates 5 cm before it, 10 cm apart.
RgbdFrame TwoPlates() {
  RgbdFrame frame{cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(100)),
                  cv::Mat(480, 640, CV_32FC1, cv::Scalar(1.0)),
                  kIntrinsics,
                  {}};
  frame.depth_m(cv::Rect(150, 150, 100, 100)).setTo(0.95);
  frame.depth_m(cv::Rect(305, 150, 100, 100)).setTo(0.95);
  frame.depth_m.rowRange(0, 10).setTo(std::numeric_limits<float>::quiet_NaN());
  return frame;
}

TEST(TableRemoval, KeepsWhatStandsOutTowardsTheCamera) {
  const PixelCloud cloud = CloudAboveTable(TwoPlates(), {});
  ASSERT_EQ(cloud.pixels.size(), 2U * 100 * 100);
  EXPECT_EQ(cloud.points->size(), cloud.pixels.size());
  EXPECT_EQ(cloud.pixels.front(), cv::Point(150, 150));
  EXPECT_EQ(cloud.pixels.back(), cv::Point(404, 249));
  EXPECT_FLOAT_EQ(cloud.points->front().x, (150 - 319.5F) * 0.95F / 525);
}

TEST(TableRemoval, KeepsAllWhereThereIsNoPlane) {
  RgbdFrame frame = TwoPlates();
  frame.depth_m.setTo(std::numeric_limits<float>::quiet_NaN());
  frame.depth_m.at<float>(100, 100) = 1;
  EXPECT_EQ(CloudAboveTable(frame, {}).pixels.size(), 1U);
}

TEST(LabelsOfPoints, NumbersTheLargeSegments) {
  const PixelCloud cloud{nullptr, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}};
  const cv::Mat labels = LabelsOfPoints(cloud, {9, 0, 9, 4, 7, 7}, {7, 1}, 2);
  const cv::Mat expected = (cv::Mat_<std::uint16_t>(1, 7) << 2, 0, 2, 0, 1, 1, 0);
  EXPECT_EQ(cv::norm(labels, expected, cv::NORM_INF), 0) << labels;
}

class Peer : public testing::TestWithParam<std::string> {};

TEST_P(Peer, FindsTwoPlates) {
  cv::Mat truth = cv::Mat::zeros(480, 640, CV_16UC1);
  truth(cv::Rect(150, 150, 100, 100)).setTo(1);
  truth(cv::Rect(305, 150, 100, 100)).setTo(2);
  const cv::Mat valid = cv::Mat::ones(480, 640, CV_8UC1);
  const SceneScores scores = ScoreScene(truth, SegmentWithPeer(GetParam(), TwoPlates()), valid);
  EXPECT_EQ(scores.counts.predicted, 2);
  EXPECT_GT(scores.overlap.f, 0.98);
}

TEST_P(Peer, FindsNothingInNothing) {
  RgbdFrame frame = TwoPlates();
  frame.depth_m.setTo(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(cv::countNonZero(SegmentWithPeer(GetParam(), frame)), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Peer, testing::ValuesIn(PeerNames()),
                         [](const auto& peer) { return peer.param; });

TEST(UnknownPeer, IsRefused) {
  EXPECT_THROW(SegmentWithPeer("none", TwoPlates()), std::invalid_argument);
}

TEST(PeerOnRecordings, LccpSegmentsATableScene) {
  const auto data = DataPath("osd");
  if (!data) GTEST_SKIP() << MissingData("osd");
  const Scene scene = LoadScene(*data, "learn0", LabelEncoding::kMosd, kIntrinsics);
  const cv::Mat labels = SegmentWithPeer("lccp", scene.frame);
  EXPECT_GT(ScoreScene(scene.truth, labels, scene.valid).overlap.f, 0.8);
}

}  // namespace
}  // namespace fovea::evaluation
