#include "core/types/lab.h"

#include <opencv2/imgproc.hpp>

namespace fovea {
namespace {

cv::Mat Convert(const cv::Mat& color_rgb) {
  cv::Mat lab;
  cv::cvtColor(color_rgb, lab, cv::COLOR_RGB2Lab);
  return lab;
}

}  // namespace

cv::Mat LabOf(const cv::Mat& color_rgb) {
  // OpenCV before 4.9 builds its tables at the first conversion without a lock (opencv#24581): here
  // one thread converts a pixel while others wait.
  static const cv::Mat first = Convert(cv::Mat::zeros(1, 1, CV_8UC3));
  return Convert(color_rgb);
}

}  // namespace fovea
