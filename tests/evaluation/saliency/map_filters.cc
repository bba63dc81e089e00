#include "tests/evaluation/saliency/map_filters.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace fovea::evaluation {

cv::Mat ScaleToUnit(const cv::Mat& map) {
  double least = 0, most = 0;
  cv::minMaxLoc(map, &least, &most);
  if (least == most) return cv::Mat::zeros(map.size(), CV_32F);
  cv::Mat scaled;
  cv::subtract(map, least, scaled);
  scaled /= most - least;
  return scaled;
}

cv::Mat Blur(const cv::Mat& map, double sigma_px, cv::BorderTypes border) {
  if (sigma_px <= 0) return map.clone();
  const int factor = std::clamp(static_cast<int>(sigma_px / 6), 1, 8);
  const cv::Size reduced_size(std::max(1, map.cols / factor), std::max(1, map.rows / factor));
  const double ratio = static_cast<double>(map.cols) / reduced_size.width;
  cv::Mat reduced, blurred;
  cv::resize(map, reduced, reduced_size, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(reduced, reduced, {}, sigma_px / ratio, sigma_px / ratio, border);
  cv::resize(reduced, blurred, map.size(), 0, 0, cv::INTER_CUBIC);
  return blurred;
}

cv::Mat CenterPrior(const cv::Size& size, double share) {
  const auto gaussian = [&](int length) {
    cv::Mat values(length, 1, CV_32F);
    for (int i = 0; i < length; ++i) {
      const double distance = (i - (length - 1) / 2.0) / (share * length);
      values.at<float>(i) = static_cast<float>(std::exp(-distance * distance / 2));
    }
    return values;
  };
  return gaussian(size.height) * gaussian(size.width).t();
}

}  // namespace fovea::evaluation
