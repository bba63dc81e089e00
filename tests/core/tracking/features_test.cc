#include "core/tracking/features.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::View;

TEST(Features, AreNotBesideStepsAndHolesOfDepth) {
  View view;
  view.Cover({100, 60, 60, 100}, 0.9F).Cover({200, 60, 60, 100}, std::nanf(""));
  const Features features = FindFeatures(view.frame, view.detections.labels);
  int before = 0;
  for (const Eigen::Vector2d& pixel : features.pixels) {
    const cv::Point at(cvRound(pixel.x()), cvRound(pixel.y()));
    const cv::Rect around(at - cv::Point(2, 2), cv::Size(5, 5));
    const cv::Mat near = view.frame.depth_m(around);
    EXPECT_EQ(cv::countNonZero(near == view.frame.depth_m.at<float>(at)), 25) << at;
    before += cv::Rect(100, 60, 60, 100).contains(at) ? 1 : 0;
  }
  EXPECT_GT(before, 0);
}

// The same picture 640 and 2560 pixels wide, of which the middle of a pixel is that of 4 x 4.
TEST(Features, OfALargeImageAreWhereTheyAreInIt) {
  const auto features_of = [](int scale) {
    const auto pixel = [&](double small) { return scale * (small + 0.5) - 0.5; };
    const View view;
    RgbdFrame frame;
    const cv::Size size(640 * scale, 480 * scale);
    cv::resize(view.frame.color_rgb, frame.color_rgb, size, 0, 0, cv::INTER_NEAREST);
    frame.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(1));
    frame.intrinsics = {500.0 * scale, 500.0 * scale, pixel(319.5), pixel(239.5)};
    return FindFeatures(frame, cv::Mat::zeros(size, CV_16UC1));
  };
  const Features small = features_of(1), large = features_of(4);
  ASSERT_GT(small.points.size(), 100U);
  ASSERT_EQ(large.points.size(), small.points.size());
  for (std::size_t i = 0; i < small.points.size(); ++i) {
    EXPECT_LT((large.points[i] - small.points[i]).norm(), 1e-6);
  }
}

// The second of two is like the only other one, too, but less.
TEST(Features, AreMatchedWhereEachIsTheOthersNearest) {
  Features from, to;
  from.descriptors = (cv::Mat_<std::uint8_t>(2, 1) << 0b0000, 0b0001);
  to.descriptors = (cv::Mat_<std::uint8_t>(1, 1) << 0b0000);
  from.points.resize(2);
  to.points.resize(1);
  EXPECT_EQ(MatchFeatures(from, to), (std::vector<std::pair<int, int>>{{0, 0}}));
}

}  // namespace
}  // namespace fovea
