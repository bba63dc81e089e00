#include "core/objects/mask_holes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kAround_px = 6;            // from an object, what it lies on is seen
constexpr double kJustNoticeable = 2.3;  // difference of colours (Mahy et al. 1994)

struct Bounds {
  int label = 0;
  cv::Rect rect;
};

// Of each label that there is, smaller ones first.
std::vector<Bounds> BoundsOfLabels(const cv::Mat& labels) {
  std::vector<Bounds> bounds;
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0) continue;
      if (label[col] > bounds.size()) bounds.resize(label[col]);
      bounds[label[col] - 1].label = label[col];
      bounds[label[col] - 1].rect |= cv::Rect(col, row, 1, 1);
    }
  }
  std::erase_if(bounds, [](const Bounds& each) { return each.label == 0; });
  std::stable_sort(bounds.begin(), bounds.end(),
                   [](const Bounds& a, const Bounds& b) { return a.rect.area() < b.rect.area(); });
  return bounds;
}

double Distance(const cv::Scalar& a, const cv::Scalar& b) {
  constexpr double kLightness = 100.0 / 255;  // LabOf stretches it
  return std::hypot(kLightness * (a[0] - b[0]), a[1] - b[1], a[2] - b[2]);
}

// `lab` and `labels`: of the bounds and what is around them.
void FillHolesOf(int label, const cv::Mat& lab, cv::Mat& labels) {
  constexpr int kOutside = 128;  // neither the object nor enclosed by it
  const cv::Mat mask = labels == label;
  cv::Mat padded;
  cv::copyMakeBorder(mask, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::floodFill(padded, {0, 0}, kOutside);
  if (cv::countNonZero(padded) == static_cast<int>(padded.total())) return;

  const cv::Mat filled = padded(cv::Rect({1, 1}, mask.size())) != kOutside, free = labels == 0;
  cv::Mat parts, bounds, middles;
  const int num_parts = cv::connectedComponentsWithStats(filled & free, parts, bounds, middles, 4);
  if (num_parts == 1) return;  // the first is what is no hole

  cv::Mat reached;
  cv::dilate(filled, reached, cv::Mat::ones(2 * kAround_px + 1, 2 * kAround_px + 1, CV_8UC1));
  const cv::Mat around = reached & ~filled & free;
  if (cv::countNonZero(around) == 0) return;
  const cv::Scalar color = cv::mean(lab, mask), color_around = cv::mean(lab, around);
  for (int part = 1; part < num_parts; ++part) {
    const int* of_part = bounds.ptr<int>(part);
    const cv::Rect rect(of_part[cv::CC_STAT_LEFT], of_part[cv::CC_STAT_TOP],
                        of_part[cv::CC_STAT_WIDTH], of_part[cv::CC_STAT_HEIGHT]);
    const cv::Mat hole = parts(rect) == part;
    const cv::Scalar in_it = cv::mean(lab(rect), hole);
    const double nearer = Distance(in_it, color_around) - Distance(in_it, color);
    if (nearer > kJustNoticeable) labels(rect).setTo(label, hole);
  }
}

}  // namespace

void FillMaskHoles(const cv::Mat& lab, cv::Mat& labels) {
  const cv::Point around(kAround_px, kAround_px);
  for (const auto& [label, rect] : BoundsOfLabels(labels)) {
    InterruptionPoint();
    const cv::Rect area =
        cv::Rect(rect.tl() - around, rect.br() + around) & cv::Rect({}, labels.size());
    cv::Mat of_area = labels(area);
    FillHolesOf(label, lab(area), of_area);
  }
}

}  // namespace fovea
