#include "core/paper/color_merge.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

// The bins of a histogram that count anything: of noise there are too many segments for a whole
// one each.
using SparseHistogram = std::vector<std::pair<int, int>>;  // bin, count; ascending

std::vector<SparseHistogram> ColorHistograms(const VoxelGrid& grid, const std::vector<int>& labels,
                                             int num_labels, const cv::Mat& color_rgb, int bins) {
  struct Run {  // of pixels beside each other
    int label, bin, count;
  };
  std::vector<Run> seen;
  for (int row = 0; row < color_rgb.rows; ++row) {
    InterruptionPoint();
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = color_rgb.ptr<cv::Vec3b>(row);
    for (int col = 0; col < color_rgb.cols; ++col) {
      const int label = voxel[col] < 0 ? 0 : labels[voxel[col]];
      if (label == 0) continue;
      const auto bin = [&](int channel) { return color[col][channel] * bins / 256; };
      const Run own{label, (bin(0) * bins + bin(1)) * bins + bin(2), 1};
      if (!seen.empty() && seen.back().label == own.label && seen.back().bin == own.bin) {
        ++seen.back().count;
      } else {
        seen.push_back(own);
      }
    }
  }
  std::sort(seen.begin(), seen.end(), [](const Run& a, const Run& b) {
    return std::tie(a.label, a.bin) < std::tie(b.label, b.bin);
  });
  std::vector<SparseHistogram> histograms(num_labels + 1);
  for (const auto& [label, bin, count] : seen) {
    SparseHistogram& histogram = histograms[label];
    if (histogram.empty() || histogram.back().first != bin) histogram.emplace_back(bin, 0);
    histogram.back().second += count;
  }
  return histograms;
}

// L2-normalised.
cv::Mat Whole(const SparseHistogram& sparse, int bins) {
  cv::Mat histogram = cv::Mat::zeros(1, bins * bins * bins, CV_32FC1);
  for (const auto& [bin, count] : sparse) histogram.at<float>(bin) = static_cast<float>(count);
  cv::normalize(histogram, histogram);
  return histogram;
}

std::set<std::pair<int, int>> NeighboringLabels(const VoxelGrid& grid,
                                                const std::vector<int>& labels) {
  std::set<std::pair<int, int>> pairs;
  for (const VoxelEdge& edge : grid.edges) {
    const auto [low, high] = std::minmax(labels[edge.a], labels[edge.b]);
    if (low > 0 && low != high) pairs.emplace(low, high);
  }
  return pairs;
}

std::vector<int> MergeOnce(const VoxelGrid& grid, const std::vector<int>& labels,
                           const cv::Mat& color_rgb, const ColorMergeOptions& options) {
  const int num_labels = static_cast<int>(CountLabels(labels));
  const std::vector<SparseHistogram> histograms =
      ColorHistograms(grid, labels, num_labels, color_rgb, options.bins);
  DisjointSets objects(num_labels + 1);
  int last_a = 0;  // pairs are in the order of a
  cv::Mat of_a;
  for (const auto& [a, b] : NeighboringLabels(grid, labels)) {
    InterruptionPoint();
    if (a != last_a) of_a = Whole(histograms[a], options.bins);
    last_a = a;
    const cv::Mat of_b = Whole(histograms[b], options.bins);
    if (cv::compareHist(of_a, of_b, cv::HISTCMP_CORREL) > options.min_correlation) {
      objects.Join(a, b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace

std::vector<int> SegmentsOf(const VoxelGrid& grid, const std::vector<int>& labels,
                            const ColorMergeOptions& options) {
  std::vector<int> segments = options.split ? SplitIntoSegments(grid, labels) : Renumbered(labels);
  RequireFewSegments(segments);
  return segments;
}

std::vector<int> MergeByColor(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ColorMergeOptions& options) {
  if (options.min_correlation >= 1) return labels;
  std::vector<int> merged = MergeOnce(grid, labels, color_rgb, options);
  for (std::size_t before = CountLabels(labels); options.iterate && CountLabels(merged) < before;) {
    before = CountLabels(merged);
    merged = MergeOnce(grid, merged, color_rgb, options);
  }
  return merged;
}

}  // namespace fovea::paper
