#include "core/segmentation/color_merge.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"

namespace fovea {
namespace {

std::vector<cv::Mat> ColorHistograms(const VoxelGrid& grid, const std::vector<int>& labels,
                                     int num_labels, const cv::Mat& color_rgb, int bins) {
  std::vector<cv::Mat> histograms(num_labels + 1);
  for (cv::Mat& histogram : histograms) histogram = cv::Mat::zeros(1, bins * bins * bins, CV_32FC1);
  for (int row = 0; row < color_rgb.rows; ++row) {
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = color_rgb.ptr<cv::Vec3b>(row);
    for (int col = 0; col < color_rgb.cols; ++col) {
      const int label = voxel[col] < 0 ? 0 : labels[voxel[col]];
      if (label == 0) continue;
      const auto bin = [&](int channel) { return color[col][channel] * bins / 256; };
      histograms[label].at<float>((bin(0) * bins + bin(1)) * bins + bin(2)) += 1;
    }
  }
  for (cv::Mat& histogram : histograms) cv::normalize(histogram, histogram);
  return histograms;
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

}  // namespace

std::vector<int> MergeByColor(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ColorMergeOptions& options) {
  const int num_labels = static_cast<int>(CountLabels(labels));
  const std::vector<cv::Mat> histograms =
      ColorHistograms(grid, labels, num_labels, color_rgb, options.bins);
  DisjointSets objects(num_labels + 1);
  for (const auto& [a, b] : NeighboringLabels(grid, labels)) {
    if (cv::compareHist(histograms[a], histograms[b], cv::HISTCMP_CORREL) >
        options.min_correlation) {
      objects.Join(a, b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
