#include "core/lens/undistortion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"

namespace fovea {
namespace {

// Of each pixel of the ideal image, where the camera shows it. CV_32FC2.
cv::Mat DistortionMap(const Lens& lens) {
  cv::Mat map(lens.size(), CV_32FC2);
  for (int row = 0; row < map.rows; ++row) {
    InterruptionPoint();
    auto* place = map.ptr<cv::Point2f>(row);
    for (int col = 0; col < map.cols; ++col) place[col] = lens.Distort(cv::Point2d(col, row));
  }
  return map;
}

// Whether the sent image shows what is at this pixel of the ideal one.
bool IsSent(const Lens& lens, const cv::Point& pixel) {
  if (!lens.IsShown(pixel)) return false;
  const cv::Point sent = lens.Distort(pixel);  // rounds
  return cv::Rect({0, 0}, lens.size()).contains(sent);
}

}  // namespace

cv::Mat UndistortColor(const cv::Mat& color, const Lens& lens) {
  cv::Mat ideal;
  cv::remap(color, ideal, DistortionMap(lens), {}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return ideal;
}

cv::Mat UndistortDepth(const cv::Mat& depth_m, const Lens& lens) {
  cv::Mat ideal(depth_m.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  const cv::Rect image({0, 0}, depth_m.size());
  for (int row = 0; row < ideal.rows; ++row) {
    InterruptionPoint();
    auto* z = ideal.ptr<float>(row);
    for (int col = 0; col < ideal.cols; ++col) {
      const cv::Point2d pixel(col, row);
      if (!lens.IsShown(pixel)) continue;
      const cv::Point sent = lens.Distort(pixel);  // rounds
      if (image.contains(sent)) z[col] = depth_m.at<float>(sent);
    }
  }
  return ideal;
}

// What is seen of a row lies in one piece: the search ends where it begins, from either end.
cv::Mat UnseenBy(const Lens& lens) {
  cv::Mat unseen = cv::Mat::zeros(lens.size(), CV_8UC1);
  for (int row = 0; row < unseen.rows; ++row) {
    InterruptionPoint();
    auto* const is_unseen = unseen.ptr<std::uint8_t>(row);
    int first = 0, end = unseen.cols;
    while (first < end && !IsSent(lens, {first, row})) is_unseen[first++] = 255;
    while (end > first && !IsSent(lens, {end - 1, row})) is_unseen[--end] = 255;
  }
  return unseen;
}

cv::Rect UndistortRect(const Lens& lens, const cv::Rect& sent) {
  cv::Rect ideal;
  const auto take = [&](int x, int y) {
    const cv::Point2d pixel = lens.Undistort(cv::Point2d(x, y));
    if (std::isnan(pixel.x)) {
      ideal |= cv::Rect(x, y, 1, 1);
      return;
    }
    const auto within = [](double place, int size) {
      return static_cast<int>(std::floor(std::clamp(place, 0.0, size - 1.0)));
    };
    ideal |=
        cv::Rect(within(pixel.x, lens.size().width), within(pixel.y, lens.size().height), 2, 2);
  };
  const cv::Point last = sent.br() - cv::Point(1, 1);
  for (int x = sent.x; x <= last.x; ++x) {
    take(x, sent.y);
    take(x, last.y);
  }
  for (int y = sent.y; y <= last.y; ++y) {
    take(sent.x, y);
    take(last.x, y);
  }
  return ideal & cv::Rect({0, 0}, lens.size());
}

}  // namespace fovea
