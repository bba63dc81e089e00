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

// How many of the lines at one end of the image are for the most part not measured: a margin if
// not more than an eighth of all, else things too far away or cut out.
int Margin(const std::vector<int>& measured, int across, bool from_end) {
  const int count = static_cast<int>(measured.size());
  for (int i = 0; i < count / 8; ++i) {
    if (2 * measured[from_end ? count - 1 - i : i] >= across) return i;
  }
  return 0;
}

cv::Rect MeasuredBounds(const cv::Mat& points) {
  std::vector<int> in_row(points.rows, 0), in_col(points.cols, 0);
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    int count = 0;
    for (int col = 0; col < points.cols; ++col) {
      const int is_measured = std::isnan(point[col][2]) ? 0 : 1;
      count += is_measured;
      in_col[col] += is_measured;
    }
    in_row[row] = count;
  }
  const cv::Point first(Margin(in_col, points.rows, false), Margin(in_row, points.cols, false));
  const cv::Point end(points.cols - Margin(in_col, points.rows, true),
                      points.rows - Margin(in_row, points.cols, true));
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

bool SeenArea::CutsOff(const std::vector<cv::Point>& mask) const {
  if (EndsWith(cv::boundingRect(mask), bounds_, image_)) return true;
  return !beside_unseen_.empty() && std::any_of(mask.begin(), mask.end(), [&](const auto& pixel) {
    return beside_unseen_.at<std::uint8_t>(pixel) != 0;
  });
}

}  // namespace fovea
