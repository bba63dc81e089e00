#include "core/lens/undistortion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "tests/core/lens/small_lenses.h"

namespace fovea {
namespace {

using testing::Barrel;
using testing::Cushion;
using testing::kSize;

// A plane drawn by the lens itself: depth that grows with the ideal column.
TEST(UndistortDepth, IsWhatAPinholeCameraWouldSee) {
  const Lens lens = Barrel();
  cv::Mat sent(kSize, CV_32FC1), color(kSize, CV_8UC3);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const double column = lens.Undistort(cv::Point2d(x, y)).x;
      sent.at<float>(y, x) = static_cast<float>(1 + 0.01 * column);
      color.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(column));
    }
  }
  const cv::Mat ideal = UndistortDepth(sent, lens), ideal_color = UndistortColor(color, lens);
  int unseen = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (std::isnan(ideal.at<float>(y, x))) {
        ++unseen;
        continue;
      }
      EXPECT_NEAR(ideal.at<float>(y, x), 1 + 0.01 * x, 0.01) << x << ' ' << y;
      if (!cv::Rect(2, 2, 156, 116).contains({x, y})) continue;  // next to what nobody sees
      EXPECT_NEAR(ideal_color.at<cv::Vec3b>(y, x)[0], x, 1.5) << x << ' ' << y;
    }
  }
  EXPECT_EQ(unseen, 0);  // a barrel shows more than the ideal image
}

TEST(UndistortDepth, HasNoneWhereTheCameraDoesNotLook) {
  const Lens lens = Cushion();
  const cv::Mat ideal = UndistortDepth(cv::Mat::ones(kSize, CV_32FC1), lens);
  EXPECT_TRUE(std::isnan(ideal.at<float>(0, 0)));
  EXPECT_EQ(ideal.at<float>(60, 80), 1);
  const cv::Mat color(kSize, CV_8UC3, cv::Scalar::all(200));
  EXPECT_EQ(UndistortColor(color, lens).at<cv::Vec3b>(0, 0), cv::Vec3b::all(200)) << "goes on";
}

TEST(UnseenBy, IsWhereUndistortedDepthHasNone) {
  for (const double k1 : {0.3, 0.05, -0.2, -0.9}) {
    const Lens lens({130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {k1}}, kSize);
    const cv::Mat ideal = UndistortDepth(cv::Mat::ones(kSize, CV_32FC1), lens);
    EXPECT_EQ(cv::countNonZero(UnseenBy(lens) == (ideal == ideal)), 0) << k1;
  }
}

cv::Rect IdealOf(const Lens& lens, const cv::Rect& sent) {
  cv::Rect ideal;
  for (int y = sent.y; y < sent.br().y; ++y) {
    for (int x = sent.x; x < sent.br().x; ++x) {
      const cv::Point2d pixel = lens.Undistort(cv::Point2d(x, y));
      if (std::isnan(pixel.x)) continue;
      ideal |= cv::Rect(cv::Point(cvFloor(pixel.x), cvFloor(pixel.y)), cv::Size(2, 2));
    }
  }
  return ideal & cv::Rect({0, 0}, kSize);
}

TEST(UndistortRect, IsAroundWhatTheSentRectangleShows) {
  for (const Lens& lens : {Barrel(), Cushion()}) {
    for (const cv::Rect& sent : {cv::Rect(10, 10, 30, 20), cv::Rect(120, 90, 30, 20),
                                 cv::Rect(0, 0, 160, 20), cv::Rect(60, 0, 100, 120)}) {
      EXPECT_EQ(UndistortRect(lens, sent), IdealOf(lens, sent)) << sent;
    }
  }
}

// A barrel's border sees what is beside the ideal image, and its corner what is farther than the
// corner of that; where rays come back nothing is seen.
TEST(UndistortRect, IsNotEmptyWhereNothingOfTheIdealImageIsSeen) {
  EXPECT_EQ(UndistortRect(Barrel(), {159, 60, 1, 1}), cv::Rect(159, 59, 1, 2));
  EXPECT_EQ(UndistortRect(Barrel(), {158, 118, 2, 2}), cv::Rect(158, 118, 2, 2));
  const Lens lens({130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {-0.9}}, kSize);
  EXPECT_EQ(UndistortRect(lens, {5, 6, 3, 2}), cv::Rect(5, 6, 3, 2));
}

}  // namespace
}  // namespace fovea
