#include "core/exposure.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace fovea {
namespace {

const cv::Vec3b kSurface(120, 80, 40);
const cv::Vec3b kThing(160, 170, 180);

// A surface with a thing on a quarter of it.
cv::Mat Room(double brightness) {
  cv::Mat color_rgb(240, 320, CV_8UC3, kSurface);
  color_rgb(cv::Rect(80, 60, 160, 120)).setTo(kThing);
  return color_rgb * brightness;
}

cv::Vec3b SurfaceOf(const cv::Mat& color_rgb) { return color_rgb.at<cv::Vec3b>(10, 10); }
cv::Vec3b ThingOf(const cv::Mat& color_rgb) { return color_rgb.at<cv::Vec3b>(120, 160); }

bool IsBlank(const WellExposed& exposed) {
  const cv::Mat grey(exposed.color_rgb.size(), CV_8UC3, cv::Scalar::all(128));
  return exposed.is_blank && cv::norm(exposed.color_rgb, grey, cv::NORM_INF) == 0;
}

cv::Mat Noise(double deviation) {
  constexpr int kSeed = 5;
  cv::Mat noise(240, 320, CV_8UC3);
  cv::RNG(kSeed).fill(noise, cv::RNG::NORMAL, 3, deviation);
  return noise;
}

TEST(Expose, UsualFramesStayAsTheyAre) {
  const cv::Mat room = Room(1);
  EXPECT_EQ(Expose(room).color_rgb.data, room.data);
}

TEST(Expose, DimOnesAreBrightenedByOneFactor) {
  // Of the thing's brightness, 84, 140 is made.
  const cv::Mat bright = Expose(Room(0.5)).color_rgb;
  EXPECT_EQ(ThingOf(bright), cv::Vec3b(133, 142, 150));
  EXPECT_EQ(SurfaceOf(bright), cv::Vec3b(100, 67, 33));
}

TEST(Expose, ALampInTheDarkDoesNotHideTheRest) {
  cv::Mat room = Room(0.25);
  room(cv::Rect(300, 0, 20, 20)).setTo(cv::Scalar::all(255));
  EXPECT_EQ(ThingOf(Expose(room).color_rgb), ThingOf(Expose(Room(0.25)).color_rgb));
}

TEST(Expose, FramesThatShowNothingAreBlank) {
  EXPECT_TRUE(IsBlank(Expose(cv::Mat::zeros(240, 320, CV_8UC3))));
  EXPECT_TRUE(IsBlank(Expose(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(255)))));
  EXPECT_TRUE(IsBlank(Expose(Noise(3)))) << "noise was taken for colour";
  EXPECT_TRUE(IsBlank(Expose(cv::Mat(1, 1, CV_8UC3, cv::Scalar(255, 0, 0)))));
  EXPECT_FALSE(Expose(Room(0.05) + Noise(3)).is_blank);
}

}  // namespace
}  // namespace fovea
