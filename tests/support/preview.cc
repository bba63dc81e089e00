#include "tests/support/preview.h"

#include <opencv2/imgproc.hpp>

namespace fovea::scenes {
namespace {

cv::Mat DrawDepth(const cv::Mat& depth_m) {
  const cv::Mat measured = depth_m == depth_m;  // NaN differs from itself
  cv::Mat nearness = 1 / depth_m, grey, colors;
  nearness.setTo(0, ~measured);
  cv::normalize(nearness, grey, 0, 255, cv::NORM_MINMAX, CV_8U, measured);
  cv::applyColorMap(grey, colors, cv::COLORMAP_TURBO);
  colors.setTo(cv::Scalar::all(0), ~measured);
  return colors;
}

cv::Mat DrawLabels(const cv::Mat& labels) {
  cv::Mat hues(labels.size(), CV_8UC3), colors;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<std::uint16_t>(y, x);
      // Steps of the golden section keep the hues of neighbouring labels apart.
      const auto hue = static_cast<std::uint8_t>(label * 111 % 180);
      hues.at<cv::Vec3b>(y, x) = {hue, 200, static_cast<std::uint8_t>(label == 0 ? 0 : 255)};
    }
  }
  cv::cvtColor(hues, colors, cv::COLOR_HSV2BGR);
  return colors;
}

}  // namespace

cv::Mat DrawPreview(const LabelledFrame& labelled) {
  cv::Mat color_bgr, picture;
  cv::cvtColor(labelled.frame.color_rgb, color_bgr, cv::COLOR_RGB2BGR);
  cv::hconcat(color_bgr, DrawDepth(labelled.frame.depth_m), picture);
  cv::hconcat(picture, DrawLabels(labelled.labels), picture);
  return picture;
}

}  // namespace fovea::scenes
