#include "core/exposure.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea {
namespace {

// Means over parts of the image, which noise of single pixels hardly moves.
const cv::Size kParts(32, 24);
// Of so many parts one is darker than what is dark, and one lighter than what is light.
constexpr std::size_t kPerTail = 50;

// Of 255. No recorded frame that the models were fitted to is darker.
constexpr double kUsualLight = 140;
constexpr int kLeastRange = 4;  // less is noise
constexpr std::uint8_t kMiddle = 128;

struct Range {
  int dark = 0, light = 0;
};

Range RangeOf(const cv::Mat& color_rgb) {
  cv::Mat parts, grey;
  cv::resize(color_rgb, parts, kParts, 0, 0, cv::INTER_AREA);
  cv::cvtColor(parts, grey, cv::COLOR_RGB2GRAY);
  std::vector<std::uint8_t> sorted(grey.begin<std::uint8_t>(), grey.end<std::uint8_t>());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t tail = sorted.size() / kPerTail;
  return {sorted[tail], sorted[sorted.size() - 1 - tail]};
}

}  // namespace

WellExposed Expose(const cv::Mat& color_rgb) {
  const Range range = RangeOf(color_rgb);
  if (range.light - range.dark < kLeastRange) {
    return {cv::Mat(color_rgb.size(), CV_8UC3, cv::Scalar::all(kMiddle)), true};
  }
  if (range.light >= kUsualLight) return {color_rgb};
  return {color_rgb * (kUsualLight / range.light)};
}

}  // namespace fovea
