// Images of which strengths are compared.
#pragma once

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <random>
#include <string>

#include "tests/support/data_path.h"

namespace fovea::testing {

inline cv::Mat Noise(cv::Size size, std::mt19937& random) {
  cv::Mat image(size, CV_8U);
  for (auto& value : cv::Mat_<std::uint8_t>(image)) {
    value = static_cast<std::uint8_t>(random() % 256);
  }
  return image;
}

inline cv::Mat Gradient(cv::Size size, std::mt19937& random) {
  const int across = static_cast<int>(random() % 7), down = static_cast<int>(random() % 7);
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>((across * x + down * y) % 256);
    }
  }
  return image;
}

// Overlapping rectangles of few values: plateaus, and strengths that have to find a way round.
inline cv::Mat Plateaus(cv::Size size, std::mt19937& random) {
  cv::Mat image = cv::Mat::zeros(size, CV_8U);
  for (int i = 0; i < 40; ++i) {
    const cv::Point corner(static_cast<int>(random() % static_cast<unsigned>(size.width)),
                           static_cast<int>(random() % static_cast<unsigned>(size.height)));
    const cv::Size extent(1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20));
    image(cv::Rect(corner, extent) & cv::Rect({0, 0}, size)) = 40.0 * (random() % 7);
  }
  return image;
}

// A one-pixel corridor that winds inwards: the longest paths a propagation can meet.
inline cv::Mat Spiral(cv::Size size, std::mt19937&) {
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int rim = std::min({x, y, size.width - 1 - x, size.height - 1 - y});
      const bool gate = x == rim + 1 && y == rim + (rim / 2 % 2 == 0 ? 2 : size.height / 2 - rim);
      image.at<std::uint8_t>(y, x) = rim % 2 == 0 || gate ? 100 : 250;
    }
  }
  return image;
}

inline std::optional<cv::Mat> ReadColor(const std::string& name) {
  const auto path = DataPath(name);
  if (!path) return std::nullopt;
  cv::Mat rgb;
  cv::cvtColor(cv::imread(path->string()), rgb, cv::COLOR_BGR2RGB);
  return rgb;
}

}  // namespace fovea::testing
