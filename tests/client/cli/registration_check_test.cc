#include "client/cli/registration_check.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace fovea::cli {
namespace {

// Boxes before a floor, in colour and depth.
struct Images {
  cv::Mat color{480, 640, CV_8UC3, cv::Scalar(120, 130, 125)};
  cv::Mat depth{480, 640, CV_16UC1, cv::Scalar(1200)};
};

Images Boxes(int shift_px) {
  Images images;
  cv::RNG random(7);
  random.fill(images.color, cv::RNG::NORMAL, cv::Scalar::all(125), cv::Scalar::all(4));
  for (int i = 0; i < 8; ++i) {
    const cv::Rect box(random.uniform(90, 460), random.uniform(60, 340), random.uniform(40, 90),
                       random.uniform(40, 90));
    images.color(box).setTo(cv::Scalar(20 * i, 255 - 25 * i, 60 + 10 * i));
    images.depth(box + cv::Point(shift_px, 0)).setTo(700 + 20 * i);
  }
  return images;
}

TEST(ShiftOfDepth, IsNoneOfRegisteredDepth) {
  for (const int shift_px : {0, 4, -6}) {
    const Images images = Boxes(shift_px);
    EXPECT_FALSE(ShiftOfDepth(images.color, images.depth)) << shift_px;
  }
}

TEST(ShiftOfDepth, IsFound) {
  for (const int shift_px : {20, -28, 40}) {
    const Images images = Boxes(shift_px);
    const auto shift = ShiftOfDepth(images.color, images.depth);
    ASSERT_TRUE(shift) << shift_px;
    EXPECT_NEAR(shift->x, shift_px, 4);
    EXPECT_NEAR(shift->y, 0, 8);
  }
}

TEST(ShiftOfDepth, IsInPixelsOfTheImages) {
  const Images images = Boxes(24);
  cv::Mat color, depth;
  cv::resize(images.color, color, {}, 2, 2);
  cv::resize(images.depth, depth, {}, 2, 2, cv::INTER_NEAREST);
  const auto shift = ShiftOfDepth(color, depth);
  ASSERT_TRUE(shift);
  EXPECT_NEAR(shift->x, 48, 8);
}

TEST(ShiftOfDepth, IsNotGuessed) {
  const Images images = Boxes(20);
  EXPECT_FALSE(ShiftOfDepth(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(0)), images.depth));
  EXPECT_FALSE(ShiftOfDepth(images.color, cv::Mat(480, 640, CV_16UC1, cv::Scalar(900))));
  EXPECT_FALSE(ShiftOfDepth(images.color, images.depth(cv::Rect(0, 0, 320, 240))));
  EXPECT_FALSE(
      ShiftOfDepth(images.color(cv::Rect(0, 0, 32, 24)), images.depth(cv::Rect(0, 0, 32, 24))));
}

}  // namespace
}  // namespace fovea::cli
