#include "client/cli/registration_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea::cli {
namespace {

// Of images of about 640 pixels; larger ones are looked at in that size.
constexpr int kWidth = 640;
constexpr int kFarthestX = 60, kFarthestY = 16, kStepX = 4, kStepY = 8;
// What of a shift registrations leave, and what they do not.
constexpr int kRegistered = 8, kShifted = 16;

// Pixels at which depth leaps from one surface to another.
std::vector<cv::Point> EdgesOfDepth(const cv::Mat& depth) {
  constexpr int kAcross = 3, kBorderX = kFarthestX + 1, kBorderY = 2 * kFarthestY;
  constexpr double kLeap = 0.05;
  const auto leaps = [](std::uint16_t a, std::uint16_t b) {
    return a > 0 && b > 0 && std::abs(a - b) > kLeap * std::min(a, b);
  };
  std::vector<cv::Point> edges;
  for (int y = kBorderY; y < depth.rows - kBorderY; ++y) {
    for (int x = kBorderX; x < depth.cols - kBorderX; ++x) {
      const auto at = [&](int dx, int dy) { return depth.at<std::uint16_t>(y + dy, x + dx); };
      const bool is_edge =
          leaps(at(-1, 0), at(kAcross - 1, 0)) || leaps(at(0, -1), at(0, kAcross - 1));
      if (is_edge) edges.emplace_back(x, y);
    }
  }
  return edges;
}

// Each pixel's share of pixels around which colour changes less than around it, 0 … 255.
cv::Mat EdgesOfColor(const cv::Mat& color) {
  cv::Mat smooth, most, least;
  cv::GaussianBlur(color, smooth, {}, 1.2);
  const cv::Mat ones = cv::Mat::ones(3, 3, CV_8UC1);
  cv::dilate(smooth, most, ones);
  cv::erode(smooth, least, ones);
  std::array<cv::Mat, 3> changes;
  cv::split(most - least, changes.data());
  cv::Mat change = cv::max(cv::max(changes[0], changes[1]), changes[2]);
  cv::Mat counts, ranks(1, 256, CV_8UC1);
  cv::calcHist(std::vector{change}, {0}, {}, counts, {256}, {0, 256});
  // With half of those that are equal, which OpenCV's equalizeHist leaves out: shifts of images
  // that are flat for the most part were missed so.
  double sum = 0;
  for (int i = 0; i < 256; ++i) {
    const double own = counts.at<float>(i);
    ranks.at<std::uint8_t>(i) = cv::saturate_cast<std::uint8_t>(
        255 * (sum + own / 2) / static_cast<double>(change.total()));
    sum += own;
  }
  cv::LUT(change, ranks, change);
  cv::dilate(change, change, cv::Mat::ones(5, 5, CV_8UC1));
  return change;
}

// Mean of `color_edges` where depth would have its edges.
double MeanAt(const cv::Mat& color_edges, const std::vector<cv::Point>& edges,
              const cv::Point& shift) {
  double sum = 0;
  for (const cv::Point& edge : edges) sum += color_edges.at<std::uint8_t>(edge + shift);
  return sum / static_cast<double>(edges.size());
}

}  // namespace

std::optional<cv::Point> ShiftOfDepth(const cv::Mat& color, const cv::Mat& depth) {
  // In standard deviations of the image. No registered frame of 127, of ten cameras, has both.
  constexpr double kLeast = 0.8, kMore = 0.2, kMinDeviation = 10;
  constexpr std::size_t kMinEdges = 500;
  if (color.size() != depth.size()) return std::nullopt;
  const double scale = std::max(1.0, std::round(static_cast<double>(color.cols) / kWidth));
  cv::Mat small_color, small_depth;
  cv::resize(color, small_color, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
  cv::resize(depth, small_depth, small_color.size(), 0, 0, cv::INTER_NEAREST);
  const std::vector<cv::Point> edges = EdgesOfDepth(small_depth);
  if (edges.size() < kMinEdges) return std::nullopt;
  const cv::Mat color_edges = EdgesOfColor(small_color);
  cv::Scalar mean, deviation;
  cv::meanStdDev(color_edges, mean, deviation);
  if (deviation[0] < kMinDeviation) return std::nullopt;  // it shows nothing
  double here = 0, beside = 0;
  cv::Point best;
  for (int dy = -kFarthestY; dy <= kFarthestY; dy += kStepY) {
    for (int dx = -kFarthestX; dx <= kFarthestX; dx += kStepX) {
      const double found = MeanAt(color_edges, edges, {dx, dy});
      if (std::abs(dx) <= kRegistered && std::abs(dy) <= kRegistered) here = std::max(here, found);
      if (std::abs(dx) < kShifted || found <= beside) continue;
      beside = found;
      best = {dx, dy};
    }
  }
  const bool is_shifted =
      beside - mean[0] >= kLeast * deviation[0] && beside - here >= kMore * deviation[0];
  if (!is_shifted) return std::nullopt;
  return cv::Point(cvRound(-best.x * scale), cvRound(-best.y * scale));
}

}  // namespace fovea::cli
