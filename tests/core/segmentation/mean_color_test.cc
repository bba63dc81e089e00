#include "core/segmentation/mean_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/lab.h"

namespace fovea {
namespace {

// Distance of the colours of the halves of an image, each a voxel. The right half is light in a
// tenth of its rows, so that the frame has light places.
double Distance(const cv::Vec3b& left, const cv::Vec3b& right, const cv::Vec3b& light) {
  cv::Mat color_rgb(20, 40, CV_8UC3, left);
  color_rgb.colRange(20, 40).setTo(right);
  VoxelGrid grid;
  grid.voxels.resize(3);
  grid.voxel_of_pixel = cv::Mat(20, 40, CV_32SC1, cv::Scalar(0));
  grid.voxel_of_pixel.colRange(20, 40) = 1;
  color_rgb(cv::Rect(20, 0, 20, 3)).setTo(light);
  grid.voxel_of_pixel(cv::Rect(20, 0, 20, 3)) = 2;
  const std::vector<MeanColor> colors = ColorsOfVoxels(grid, LabOf(color_rgb));
  return colors[0].DistanceTo(colors[1]);
}

constexpr double kOneStep = 1.5;  // 8 bits in each of the channels
constexpr double kUnit = 66;
const cv::Vec3b kWhite(255, 255, 255);

TEST(ColorsOfVoxels, AreNearCielabForMiddlingLight) {
  // L = 52.2 of both, a = 42.3 and -32.0, b = 20.6 and 0.6.
  const double chroma = kUnit / 68.2 * std::hypot(42.3 + 32, 20.6 - 0.6);
  EXPECT_NEAR(Distance({198, 92, 92}, {41, 139, 123}, kWhite), chroma, 2 * kOneStep);
}

TEST(ColorsOfVoxels, DifferMoreInHueThanInLight) {
  const double sides = Distance({200, 100, 60}, {133, 64, 36}, kWhite);  // two fifths of the light
  const double things = Distance({200, 100, 60}, {100, 150, 60}, kWhite);
  EXPECT_LT(sides, 14);
  EXPECT_GT(things, 4 * sides);
}

TEST(ColorsOfVoxels, AreTheSameWhereTheFrameIsDark) {
  const double light = Distance({150, 90, 60}, {60, 90, 150}, {122, 122, 122});
  const double dark = Distance({50, 30, 20}, {20, 30, 50}, {41, 41, 41});
  EXPECT_NEAR(dark, light, 0.25 * light) << "a colour of 8 bits has few steps in the dark";
}

TEST(ColorsOfVoxels, OfABlackFrameStayFinite) {
  EXPECT_NEAR(Distance({0, 0, 0}, {3, 0, 0}, {0, 0, 0}), 0, 12);
}

TEST(ColorsOfVoxels, DifferInHueAsUsualWhereTheFrameIsGrey) {
  // L = 40.7 and 61.7.
  const double in_light = 0.5 * kUnit * std::log((61.7 + 16) / (40.7 + 16));
  EXPECT_NEAR(Distance({96, 96, 96}, {149, 149, 149}, {200, 20, 20}), in_light, kOneStep);
  EXPECT_NEAR(Distance({96, 96, 96}, {149, 149, 149}, {200, 200, 200}), std::hypot(in_light, 8),
              kOneStep);
  EXPECT_NEAR(Distance({96, 96, 96}, {96, 96, 96}, {96, 96, 96}), 8, 1e-9);
}

}  // namespace
}  // namespace fovea
