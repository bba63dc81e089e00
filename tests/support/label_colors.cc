#include "tests/support/label_colors.h"

#include <opencv2/imgproc.hpp>

namespace fovea::scenes {

cv::Mat ColorLabels(const cv::Mat& labels) {
  cv::Mat hues(labels.size(), CV_8UC3), colors_bgr;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<std::uint16_t>(y, x);
      // Steps of the golden section keep the hues of neighbouring labels apart.
      const auto hue = static_cast<std::uint8_t>(label * 111 % 180);
      hues.at<cv::Vec3b>(y, x) = {hue, 210, static_cast<std::uint8_t>(label == 0 ? 0 : 255)};
    }
  }
  cv::cvtColor(hues, colors_bgr, cv::COLOR_HSV2BGR);
  return colors_bgr;
}

}  // namespace fovea::scenes
