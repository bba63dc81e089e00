#include "core/seeds/saliency_seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

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

std::vector<std::vector<cv::Point>> PixelsOfPeaks(const cv::Mat& peaks) {
  InterruptionPoint();
  std::vector<std::vector<cv::Point>> pixels;
  for (int row = 0; row < peaks.rows; ++row) {
    const int* peak = peaks.ptr<int>(row);
    for (int col = 0; col < peaks.cols; ++col) {
      if (peak[col] == 0) continue;
      const auto number = static_cast<std::size_t>(peak[col]);
      if (number > pixels.size()) pixels.resize(number);
      pixels[number - 1].emplace_back(col, row);
    }
  }
  return pixels;
}

cv::Point Centroid(const std::vector<cv::Point>& pixels) {
  cv::Point2d sum;
  for (const cv::Point& pixel : pixels) sum += cv::Point2d(pixel);
  const double count = static_cast<double>(pixels.size());
  return {cvRound(sum.x / count), cvRound(sum.y / count)};
}

std::optional<cv::Point> NearestMeasured(const std::vector<cv::Point>& pixels,
                                         const cv::Point& center, const cv::Mat& points) {
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

std::optional<cv::Point> PixelOfPeak(const std::vector<cv::Point>& pixels, const cv::Point& center,
                                     const cv::Mat& points, bool on_peak) {
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
  for (const std::vector<cv::Point>& peak : PixelsOfPeaks(peaks)) {
    loop.Turn();
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
