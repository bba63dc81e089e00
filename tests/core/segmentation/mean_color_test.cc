#include "core/segmentation/mean_color.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

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
  const std::vector<MeanColor> colors = ColorsOfVoxels(grid, {1, 1, 1}, color_rgb);
  return colors[0].DistanceTo(colors[1]);
}

constexpr double kOneStep = 1.5;  // 8 bits in each of the channels

TEST(ColorsOfVoxels, AreCielabWhereTheFrameIsLight) {
  // L = 53.2 and 87.7, a = 80 and -86, b = 67 and 83.
  EXPECT_NEAR(Distance({255, 0, 0}, {0, 255, 0}, {255, 255, 255}), 170.6, kOneStep);
}

TEST(ColorsOfVoxels, AreFartherApartWhereTheFrameIsDark) {
  const double light = Distance({150, 90, 60}, {60, 90, 150}, {122, 122, 122});  // L = 51
  const double dark = Distance({50, 30, 20}, {20, 30, 50}, {41, 41, 41});        // L = 16
  EXPECT_NEAR(dark, light, 0.3 * light);  // with colours as they are it would be 26
}

TEST(ColorsOfVoxels, OfABlackFrameStayFinite) {
  EXPECT_NEAR(Distance({0, 0, 0}, {3, 0, 0}, {0, 0, 0}), 0, 12);
}

TEST(ColorsOfVoxels, DifferMoreInLightnessWhereTheFrameIsGrey) {
  // L = 40.7 and 61.7.
  EXPECT_NEAR(Distance({96, 96, 96}, {149, 149, 149}, {200, 200, 200}), 1.75 * 21, 1.75 * kOneStep);
}

}  // namespace
}  // namespace fovea
