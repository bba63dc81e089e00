#include "core/seeds/saliency_seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/seeds/morphology.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

bool HasPoint(const cv::Mat& points, const cv::Point& pixel) {
  return !std::isnan(points.at<cv::Vec3f>(pixel)[2]);
}

void TakeHigher(const float* row, std::vector<float>& highest) {
  for (std::size_t x = 0; x < highest.size(); ++x) highest[x] = std::max(highest[x], row[x]);
}

// Maximum of every block; those at the right and lower end may be cut.
cv::Mat BlockMaxima(const cv::Mat& map, int block_px) {
  InterruptionPoint();
  const int rows = (map.rows + block_px - 1) / block_px;
  const int cols = (map.cols + block_px - 1) / block_px;
  cv::Mat maxima(rows, cols, CV_32F, cv::Scalar::all(std::numeric_limits<float>::lowest()));
  std::vector<float> highest(map.cols);  // of each column, within a row of blocks
  for (int block_row = 0; block_row < rows; ++block_row) {
    const int first = block_row * block_px;
    const int end = std::min(first + block_px, map.rows);
    std::copy_n(map.ptr<float>(first), map.cols, highest.begin());
    for (int y = first + 1; y < end; ++y) TakeHigher(map.ptr<float>(y), highest);
    float* most = maxima.ptr<float>(block_row);
    for (int x = 0, block = 0; x < map.cols; ++block) {
      const int block_end = std::min(x + block_px, map.cols);
      for (; x < block_end; ++x) most[block] = std::max(most[block], highest[x]);
    }
  }
  return maxima;
}

// The flat peaks of the opened map, numbered. What is flat in a map is flat in its reconstruction,
// so that one pixel may stand for each block.
cv::Mat FindPeaks(const cv::Mat& saliency, int radius_px, int block_px) {
  const cv::Mat eroded = ErodeByDisk(saliency, radius_px);
  if (block_px == 1) return LabelRegionalMaxima(ReconstructByDilation(eroded, saliency));
  const cv::Mat opened =
      ReconstructByDilation(BlockMaxima(eroded, block_px), BlockMaxima(saliency, block_px));
  cv::Mat peaks;
  cv::resize(LabelRegionalMaxima(opened), peaks, opened.size() * block_px, 0, 0, cv::INTER_NEAREST);
  return peaks(cv::Rect({}, saliency.size()));
}

using Pixels = std::span<const cv::Point>;

// The pixels of each peak, in row-major order; one after the other in one piece of memory.
class PixelsOfPeaks {
 public:
  explicit PixelsOfPeaks(const cv::Mat& peaks) : first_(2, 0) {
    InterruptionPoint();
    ForEachPixel(peaks, [&](std::size_t peak, const cv::Point& /*pixel*/) {
      if (peak + 2 > first_.size()) first_.resize(peak + 2, 0);
      ++first_[peak + 1];
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    pixels_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    ForEachPixel(peaks,
                 [&](std::size_t peak, const cv::Point& pixel) { pixels_[next[peak]++] = pixel; });
  }

  std::size_t Count() const { return first_.size() - 2; }
  // `peak`: 1 … Count()
  Pixels Of(std::size_t peak) const {
    return Pixels(pixels_).subspan(first_[peak], first_[peak + 1] - first_[peak]);
  }

 private:
  static void ForEachPixel(const cv::Mat& peaks, const auto& visit) {
    for (int row = 0; row < peaks.rows; ++row) {
      const int* peak = peaks.ptr<int>(row);
      for (int col = 0; col < peaks.cols; ++col) {
        if (peak[col] != 0) visit(static_cast<std::size_t>(peak[col]), cv::Point(col, row));
      }
    }
  }

  std::vector<std::size_t> first_;  // of each number in pixels_; one more at the end
  std::vector<cv::Point> pixels_;
};

cv::Point Centroid(Pixels pixels) {
  cv::Point2d sum;
  for (const cv::Point& pixel : pixels) sum += cv::Point2d(pixel);
  const double count = static_cast<double>(pixels.size());
  return {cvRound(sum.x / count), cvRound(sum.y / count)};
}

std::optional<cv::Point> NearestMeasured(Pixels pixels, const cv::Point& center,
                                         const cv::Mat& points) {
  std::optional<cv::Point> nearest;
  int nearest_distance = 0;
  for (const cv::Point& pixel : pixels) {
    const cv::Point offset = pixel - center;
    const int distance = offset.dot(offset);
    if (!HasPoint(points, pixel) || (nearest && distance >= nearest_distance)) continue;
    nearest = pixel;
    nearest_distance = distance;
  }
  return nearest;
}

std::optional<cv::Point> PixelOfPeak(Pixels pixels, const cv::Point& center, const cv::Mat& points,
                                     bool on_peak) {
  if (on_peak) return NearestMeasured(pixels, center, points);
  if (HasPoint(points, center)) return center;
  return std::nullopt;
}

}  // namespace

SeedCandidates FindSeeds(const cv::Mat& saliency, const cv::Mat& points, Seed::Source source,
                         const SeedOptions& options, int block_px) {
  const int radius_px = ScaledPx(options.disk_radius_px, saliency.cols, 0);
  const cv::Mat peaks = FindPeaks(saliency, radius_px, block_px);
  SeedCandidates candidates;
  LongLoop loop;
  const PixelsOfPeaks pixels_of(peaks);
  for (std::size_t number = 1; number <= pixels_of.Count(); ++number) {
    loop.Turn();
    const Pixels peak = pixels_of.Of(number);
    const cv::Point center = Centroid(peak);
    const std::optional<cv::Point> pixel = PixelOfPeak(peak, center, points, options.on_peak);
    if (!pixel) {
      candidates.without_depth.push_back(center);
      continue;
    }
    const cv::Vec3f& p = points.at<cv::Vec3f>(*pixel);
    candidates.seeds.push_back({*pixel, {p[0], p[1], p[2]}, source});
  }
  return candidates;
}

}  // namespace fovea
