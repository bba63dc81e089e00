#include "core/shape/outline.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/shape/outline_profiles.h"
#include "core/types/squares.h"

namespace fovea {
namespace {

constexpr double kWidth_px = 640;  // that lengths in pixels are given for
constexpr double kStep_px = 2;
constexpr std::size_t kMaxContourPoints = 160;
constexpr std::size_t kMinPoints = 12;
constexpr int kReach_px = 2;  // of what closes notches

// Of the largest part of the mask, without its notches and holes; in pixels of the image.
std::vector<cv::Point> Contour(const cv::Mat& labels, int label, const cv::Rect& bounds) {
  constexpr int kMargin_px = 2 * kReach_px + 1;
  const cv::Rect around = cv::Rect(bounds.tl() - cv::Point(kMargin_px, kMargin_px),
                                   bounds.br() + cv::Point(kMargin_px, kMargin_px)) &
                          cv::Rect({}, labels.size());
  cv::Mat mask = labels(around) == label;
  CloseGaps(kReach_px, mask);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, around.tl());
  if (contours.empty()) return {};
  return *std::max_element(contours.begin(), contours.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

// Evenly spaced, and without the corners of pixels.
std::vector<Eigen::Vector2f> Smoothed(const std::vector<cv::Point>& contour, double step) {
  const std::size_t count = std::min(
      kMaxContourPoints, static_cast<std::size_t>(static_cast<double>(contour.size()) / step));
  if (count < kMinPoints) return {};
  std::vector<Eigen::Vector2f> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const cv::Point& p = contour[i * contour.size() / count];
    points[i] = {static_cast<float>(p.x), static_cast<float>(p.y)};
  }
  std::vector<Eigen::Vector2f> before;
  for (int pass = 0; pass < 2; ++pass) {
    before = points;
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector2f& previous = before[(i + count - 1) % count];
      const Eigen::Vector2f& next = before[(i + 1) % count];
      points[i] = (previous + 2 * before[i] + next) / 4;
    }
  }
  return points;
}

// Unit vectors; of a contour as cv::findContours walks it, with the object on its left.
std::vector<Eigen::Vector2f> Outwards(const std::vector<Eigen::Vector2f>& points) {
  const std::size_t count = points.size();
  float area = 0;
  std::vector<Eigen::Vector2f> normals(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2f& next = points[(i + 1) % count];
    area += points[i].x() * next.y() - next.x() * points[i].y();
    const Eigen::Vector2f along = points[(i + 2) % count] - points[(i + count - 2) % count];
    const float length = std::max(along.norm(), 1e-6F);
    normals[i] = Eigen::Vector2f(along.y(), -along.x()) / length;
  }
  if (area < 0) {
    for (Eigen::Vector2f& normal : normals) normal = -normal;
  }
  return normals;
}

}  // namespace

std::vector<OutlinePoint> OutlineAlongColors(const RgbdFrame& frame, const PixelPoints& points,
                                             const cv::Mat& labels, int label,
                                             const cv::Rect& bounds) {
  const double scale = std::max(1.0, labels.cols / kWidth_px);
  const std::vector<Eigen::Vector2f> contour =
      Smoothed(Contour(labels, label, bounds), kStep_px * scale);
  const std::vector<Eigen::Vector2f> outwards = Outwards(contour);
  const OutlineProfiles profiles(frame.color_rgb, points.Depth_m(), labels, label, contour,
                                 outwards, static_cast<float>(scale));
  const std::vector<int> offsets = profiles.BestWayAround();
  std::vector<OutlinePoint> outline(contour.size());
  for (std::size_t i = 0; i < contour.size(); ++i) {
    // The edge lies between the last place inside and the first outside.
    const float offset = (static_cast<float>(offsets[i]) + 0.5F) * static_cast<float>(scale);
    const OutlineProfiles::Sample* beyond = profiles.Beyond(i, offsets[i]);
    outline[i] = {.pixel = contour[i] + outwards[i] * offset,
                  .outwards = outwards[i],
                  .is_own_end = profiles.EndsAt(i, offsets[i], beyond)};
    if (beyond == nullptr) continue;
    outline[i].beyond = points.At(beyond->pixel.y, beyond->pixel.x);
    outline[i].label_beyond = beyond->label;
  }
  return outline;
}

}  // namespace fovea
