// Algorithm 1 of the paper, word for word.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea::testing {

inline float LiteralFactor(int a, int b) {
  const auto difference = static_cast<float>(std::abs(a - b));
  return 1.0F - difference / 255.0F;
}

inline std::vector<cv::Point> Ring(int scale) {
  std::vector<cv::Point> offsets;
  for (int y = -scale; y <= scale; ++y) {
    for (int x = -scale; x <= scale; ++x) {
      if (std::max(std::abs(x), std::abs(y)) == scale) offsets.emplace_back(x, y);
    }
  }
  return offsets;
}

// Every pixel takes its new strength from all the old ones, again and again.
inline cv::Mat LiteralStrength(const cv::Mat& channel, int scale) {
  const std::vector<cv::Point> ring = Ring(scale);
  cv::Mat strength = cv::Mat::ones(channel.size(), CV_32F);
  std::vector<cv::Point> inside;
  for (int y = scale; y < channel.rows - scale; ++y) {
    for (int x = scale; x < channel.cols - scale; ++x) {
      inside.emplace_back(x, y);
      strength.at<float>(y, x) = 0;
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    const cv::Mat before = strength.clone();
    for (const cv::Point& i : inside) {
      float most = 0;
      for (const cv::Point& offset : ring) {
        const cv::Point j = i + offset;
        const float factor =
            LiteralFactor(channel.at<std::uint8_t>(i), channel.at<std::uint8_t>(j));
        most = std::max(most, before.at<float>(j) * factor);
      }
      changed |= most != strength.at<float>(i);
      strength.at<float>(i) = most;
    }
  }
  return strength;
}

inline cv::Mat LiteralSaliency(const cv::Mat& color_rgb, int num_scales) {
  cv::Mat lab;
  cv::cvtColor(color_rgb, lab, cv::COLOR_RGB2Lab);
  std::array<cv::Mat, 3> channels;
  cv::split(lab, channels.data());
  cv::Mat sum = cv::Mat::zeros(color_rgb.size(), CV_32F);
  for (int scale = 1; scale <= num_scales; ++scale) {
    for (const cv::Mat& channel : channels) sum += 1.0 - LiteralStrength(channel, scale);
  }
  const double norm = cv::norm(sum, cv::NORM_L2);
  return norm > 0 ? cv::Mat(sum / norm) : sum;
}

}  // namespace fovea::testing
