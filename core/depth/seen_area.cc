#include "core/depth/seen_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kUnevenPx = 6;  // in an image 640 wide
constexpr int kTogether = 16;    // columns, of a piece of memory

// Of each of some columns, in how many rows it was measured; row by row, as images lie in memory.
std::array<int, kTogether> CountInColumns(const cv::Mat& depth_m, const cv::Range& columns) {
  const int step = depth_m.channels(), num = columns.size();
  std::array<int, kTogether> counts{};
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* depth = depth_m.ptr<float>(row, columns.start) + step - 1;
    for (int i = 0; i < num; ++i, depth += step) counts[i] += std::isnan(*depth) ? 0 : 1;
  }
  return counts;
}

bool IsMostOfRowMeasured(const cv::Mat& depth_m, int row) {
  const int step = depth_m.channels();
  const float* depth = depth_m.ptr<float>(row) + step - 1;
  int count = 0;
  for (int col = 0; col < depth_m.cols; ++col, depth += step) count += std::isnan(*depth) ? 0 : 1;
  return 2 * count >= depth_m.cols;
}

// How many of the rows, up to `most`, from the first one on or the last one back are for the most
// part not measured. If all of them, they are no margin but things too far away or cut out.
int MarginOfRows(const cv::Mat& depth_m, int most, bool is_first) {
  InterruptionPoint();
  for (int i = 0; i < most; ++i) {
    if (IsMostOfRowMeasured(depth_m, is_first ? i : depth_m.rows - 1 - i)) return i;
  }
  return 0;
}

// The same of columns.
int MarginOfColumns(const cv::Mat& depth_m, int most, bool is_first) {
  for (int i = 0; i < most; i += kTogether) {
    InterruptionPoint();
    const int end = std::min(i + kTogether, most), cols = depth_m.cols;
    std::array<int, kTogether> counts =
        CountInColumns(depth_m, is_first ? cv::Range(i, end) : cv::Range(cols - end, cols - i));
    const auto last = counts.begin() + (end - i);
    if (!is_first) std::reverse(counts.begin(), last);
    const auto found =
        std::find_if(counts.begin(), last, [&](int count) { return 2 * count >= depth_m.rows; });
    if (found != last) return i + static_cast<int>(found - counts.begin());
  }
  return 0;
}

cv::Rect MeasuredBounds(const cv::Mat& depth_m) {
  const int most_cols = depth_m.cols / 8, most_rows = depth_m.rows / 8;
  const cv::Point first(MarginOfColumns(depth_m, most_cols, true),
                        MarginOfRows(depth_m, most_rows, true));
  const cv::Point last(MarginOfColumns(depth_m, most_cols, false),
                       MarginOfRows(depth_m, most_rows, false));
  return {first, cv::Point(depth_m.size()) - last};
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
