#include "core/types/lab.h"

#include <gtest/gtest.h>

#include <array>
#include <latch>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <thread>

namespace fovea {
namespace {

cv::Mat OnePixel(int r, int g, int b) { return {1, 1, CV_8UC3, cv::Scalar(r, g, b)}; }

TEST(LabOf, ScalesLightnessTo255AndMovesColorsBy128) {
  EXPECT_EQ(LabOf(OnePixel(0, 0, 0)).at<cv::Vec3b>(0), cv::Vec3b(0, 128, 128));
  EXPECT_EQ(LabOf(OnePixel(255, 255, 255)).at<cv::Vec3b>(0), cv::Vec3b(255, 128, 128));
  // Red of sRGB is (53.2, 80.1, 67.2).
  EXPECT_EQ(LabOf(OnePixel(255, 0, 0)).at<cv::Vec3b>(0), cv::Vec3b(136, 208, 195));
}

// The tests run in a process each: under the address sanitizer tables that are built twice are
// found as a leak.
TEST(LabOf, FirstConversionsMayRunAtOnce) {
  const cv::Mat color = OnePixel(200, 100, 50);
  std::array<cv::Mat, 4> labs;
  {
    std::latch start(labs.size());
    std::array<std::jthread, labs.size()> threads;
    for (std::size_t i = 0; i < labs.size(); ++i) {
      threads.at(i) = std::jthread([&, i] {
        start.arrive_and_wait();
        labs.at(i) = LabOf(color);
      });
    }
  }
  cv::Mat expected;
  cv::cvtColor(color, expected, cv::COLOR_RGB2Lab);
  for (const cv::Mat& lab : labs) EXPECT_EQ(cv::norm(lab, expected, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace fovea
