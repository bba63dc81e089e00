#include "core/shape/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A red thing at 1 m before a grey wall at 1.5 m: what is red, what is measured and the mask may
// differ.
struct Picture {
  RgbdFrame frame{cv::Mat(480, 640, CV_8UC3, cv::Scalar(120, 120, 120)), {}, {}, {}};
  cv::Mat depth_m{480, 640, CV_32FC1, cv::Scalar(1.5)};
  cv::Mat labels = cv::Mat::zeros(480, 640, CV_16UC1);

  void Put(const cv::Rect& red, const cv::Rect& mask) {
    frame.color_rgb(red).setTo(cv::Scalar(200, 30, 30));
    depth_m(mask).setTo(1);
    labels(mask).setTo(1);
  }
  std::vector<OutlinePoint> Outline(const cv::Rect& mask) const {
    return OutlineAlongColors(frame, {depth_m, {525, 525, 319.5, 239.5}}, labels, 1, mask);
  }
};

// Of points that look to the right. Pixel k reaches from k - 0.5 to k + 0.5.
float RightEnd(const std::vector<OutlinePoint>& outline) {
  std::vector<float> ends;
  for (const OutlinePoint& point : outline) {
    if (point.outwards.x() > 0.95F) ends.push_back(point.pixel.x());
  }
  std::nth_element(ends.begin(), ends.begin() + static_cast<int>(ends.size() / 2), ends.end());
  return ends[ends.size() / 2];
}

TEST(OutlineAlongColors, GoesOutToTheColorsWhereDepthIsMissing) {
  const cv::Rect red(200, 150, 100, 100), mask(200, 150, 94, 100);
  Picture picture;
  picture.depth_m(cv::Rect(200, 150, 108, 100)).setTo(kNone);
  picture.Put(red, mask);
  EXPECT_NEAR(RightEnd(picture.Outline(mask)), 299.5, 0.6F);
}

TEST(OutlineAlongColors, GoesInToTheColorsWhereDepthReachesOver) {
  const cv::Rect red(200, 150, 100, 100), mask(196, 146, 108, 108);
  Picture picture;
  picture.Put(red, mask);
  EXPECT_NEAR(RightEnd(picture.Outline(mask)), 299.5, 0.6F);
}

TEST(OutlineAlongColors, StaysAtTheMaskWhereColorsTellNothing) {
  const cv::Rect mask(200, 150, 100, 100);
  Picture picture;
  picture.Put(mask, mask);
  picture.frame.color_rgb.setTo(cv::Scalar(90, 90, 90));
  EXPECT_NEAR(RightEnd(picture.Outline(mask)), 299.5, 0.6F);
}

TEST(OutlineAlongColors, KnowsWhereSomethingNearerOrTheImageEndsIt) {
  const cv::Rect mask(540, 150, 100, 100);
  Picture picture;
  picture.Put(mask, mask);
  picture.depth_m(cv::Rect(500, 250, 140, 60)).setTo(0.8);
  for (const OutlinePoint& point : picture.Outline(mask)) {
    if (std::max(std::abs(point.outwards.x()), std::abs(point.outwards.y())) < 0.95F) continue;
    const bool is_hidden = point.outwards.y() > 0.95F || point.outwards.x() > 0.95F;
    EXPECT_EQ(point.is_own_end, !is_hidden) << point.pixel.transpose();
    if (!point.is_own_end) continue;
    EXPECT_FLOAT_EQ(point.beyond.z(), 1.5F);
  }
}

TEST(OutlineAlongColors, HasAtMost160PointsAndNoneOfAFewPixels) {
  Picture picture;
  const cv::Rect all(0, 0, 640, 480), few(100, 100, 3, 3);
  picture.Put(all, all);
  EXPECT_EQ(picture.Outline(all).size(), 160U);
  Picture other;
  other.Put(few, few);
  EXPECT_TRUE(other.Outline(few).empty());
}

}  // namespace
}  // namespace fovea
