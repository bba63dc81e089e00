#include "core/depth/seen_area.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kUnevenPx = 6;  // in an image 640 wide

bool IsMeasured(const cv::Mat& points, int row, int col) {
  return !std::isnan(points.ptr<cv::Vec3f>(row)[col][2]);
}

bool MostOfRow(const cv::Mat& points, int row) {
  int count = 0;
  for (int col = 0; col < points.cols; ++col) count += IsMeasured(points, row, col) ? 1 : 0;
  return 2 * count >= points.cols;
}

bool MostOfColumn(const cv::Mat& points, int col) {
  int count = 0;
  for (int row = 0; row < points.rows; ++row) count += IsMeasured(points, row, col) ? 1 : 0;
  return 2 * count >= points.rows;
}

// How many of the lines at one end of the image are for the most part not measured: a margin if
// not more than an eighth of all, else things too far away or cut out. `first`: of that end, from
// which on they are looked at in steps of one or minus one.
template <typename IsMeasuredLine>
int Margin(int count, const IsMeasuredLine& is_measured, int first, int step) {
  InterruptionPoint();
  for (int i = 0; i < count / 8; ++i) {
    if (is_measured(first + i * step)) return i;
  }
  return 0;
}

cv::Rect MeasuredBounds(const cv::Mat& points) {
  const auto row = [&](int y) { return MostOfRow(points, y); };
  const auto column = [&](int x) { return MostOfColumn(points, x); };
  const int width = points.cols, height = points.rows;
  const cv::Point first(Margin(width, column, 0, 1), Margin(height, row, 0, 1));
  const cv::Point end(width - Margin(width, column, width - 1, -1),
                      height - Margin(height, row, height - 1, -1));
  return {first, end};
}

bool EndsWith(const cv::Rect& mask, const cv::Rect& measured, const cv::Size& image) {
  const int uneven_px = ScaledPx(kUnevenPx, image.width, 1);
  // The nearest to the upper or left end that a mask may be, and still end there.
  const auto limit = [&](int margin) { return margin == 0 ? 0 : margin + uneven_px; };
  const cv::Point end = cv::Point(image) - measured.br();
  const cv::Point to_end = cv::Point(image) - mask.br();
  return mask.x <= limit(measured.x) || mask.y <= limit(measured.y) || to_end.x <= limit(end.x) ||
         to_end.y <= limit(end.y);
}

}  // namespace

SeenArea::SeenArea(const cv::Mat& points, const cv::Mat& unseen)
    : image_(points.size()), bounds_(MeasuredBounds(points)), unseen_(unseen) {
  if (unseen.empty()) return;
  const int uneven_px = ScaledPx(kUnevenPx, image_.width, 1);
  cv::dilate(unseen, beside_unseen_, cv::Mat::ones(2 * uneven_px + 1, 2 * uneven_px + 1, CV_8UC1));
}

bool SeenArea::Contains(const cv::Point& pixel) const {
  return bounds_.contains(pixel) && (unseen_.empty() || unseen_.at<std::uint8_t>(pixel) == 0);
}

bool SeenArea::CutsOff(const PixelRuns& mask) const {
  if (EndsWith(BoundsOf(mask), bounds_, image_)) return true;
  return !beside_unseen_.empty() && std::any_of(mask.begin(), mask.end(), [&](const auto& run) {
    const auto* is_beside = beside_unseen_.ptr<std::uint8_t>(run.row);
    return std::any_of(is_beside + run.first, is_beside + run.end,
                       [](std::uint8_t beside) { return beside != 0; });
  });
}

}  // namespace fovea
