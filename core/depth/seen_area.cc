#include "core/depth/seen_area.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kUnevenPx = 6;  // in an image 640 wide

// Of each of some columns, in how many rows it was measured; row by row, as images lie in memory.
std::vector<int> CountInColumns(const cv::Mat& depth_m, const cv::Range& columns) {
  const int step = depth_m.channels(), num = columns.size();
  std::vector<int> counts(num);
  int* const count = counts.data();
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* depth = depth_m.ptr<float>(row) + columns.start * step + step - 1;
    for (int i = 0; i < num; ++i) count[i] += std::isnan(depth[i * step]) ? 0 : 1;
  }
  return counts;
}

bool IsMostOfRowMeasured(const cv::Mat& depth_m, int row) {
  const int step = depth_m.channels();
  const float* depth = depth_m.ptr<float>(row) + step - 1;
  int count = 0;
  for (int col = 0; col < depth_m.cols; ++col) count += std::isnan(depth[col * step]) ? 0 : 1;
  return 2 * count >= depth_m.cols;
}

// How many of the lines at one end of the image, up to `most`, are for the most part not measured.
// If all of them, they are no margin but things too far away or cut out.
template <typename IsMeasuredLine>
int Margin(int most, const IsMeasuredLine& is_measured) {
  InterruptionPoint();
  for (int i = 0; i < most; ++i) {
    if (is_measured(i)) return i;
  }
  return 0;
}

cv::Rect MeasuredBounds(const cv::Mat& depth_m) {
  const int width = depth_m.cols, height = depth_m.rows;
  const int most_cols = width / 8, most_rows = height / 8;
  const std::vector<int> left = CountInColumns(depth_m, {0, most_cols});
  const std::vector<int> right = CountInColumns(depth_m, {width - most_cols, width});
  const auto row = [&](int y) { return IsMostOfRowMeasured(depth_m, y); };
  const cv::Point first(Margin(most_cols, [&](int i) { return 2 * left[i] >= height; }),
                        Margin(most_rows, row));
  const cv::Point margin(
      Margin(most_cols, [&](int i) { return 2 * right[most_cols - 1 - i] >= height; }),
      Margin(most_rows, [&](int i) { return row(height - 1 - i); }));
  return {first, cv::Point(depth_m.size()) - margin};
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

SeenArea::SeenArea(const cv::Mat& depth_m, const cv::Mat& unseen)
    : image_(depth_m.size()), bounds_(MeasuredBounds(depth_m)), unseen_(unseen) {
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
