#include "tests/support/preview.h"

#include <opencv2/imgproc.hpp>

#include "tests/support/label_colors.h"

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

}  // namespace

cv::Mat DrawPreview(const LabelledFrame& labelled) {
  cv::Mat color_bgr, picture;
  cv::cvtColor(labelled.frame.color_rgb, color_bgr, cv::COLOR_RGB2BGR);
  cv::hconcat(color_bgr, DrawDepth(labelled.frame.depth_m), picture);
  cv::hconcat(picture, ColorLabels(labelled.labels), picture);
  return picture;
}

}  // namespace fovea::scenes
