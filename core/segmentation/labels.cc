#include "core/segmentation/labels.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/types/interruption.h"
#include "core/types/too_complex.h"

namespace fovea {
std::vector<int> Renumbered(std::vector<int> labels) {
  InterruptionPoint();
  std::vector<int> number(CountLabels(labels) + 1, 0);
  int count = 0;
  for (int& label : labels) {
    if (label == 0) continue;
    if (number[label] == 0) number[label] = ++count;
    label = number[label];
  }
  return labels;
}

std::vector<int> SplitIntoSegments(const VoxelGrid& grid, const std::vector<int>& labels) {
  DisjointSets parts(static_cast<int>(labels.size()));
  InterruptionPoint();
  for (const VoxelEdge& edge : grid.edges) {
    if (labels[edge.a] != 0 && labels[edge.a] == labels[edge.b]) parts.Join(edge.a, edge.b);
  }
  std::vector<int> segments(labels.size(), 0);
  InterruptionPoint();
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] != 0) segments[v] = parts.Find(static_cast<int>(v)) + 1;
  }
  return Renumbered(std::move(segments));
}

std::vector<int> PartsOfForeground(const VoxelGrid& grid, const std::vector<char>& is_background) {
  std::vector<int> foreground(is_background.size());
  std::transform(is_background.begin(), is_background.end(), foreground.begin(),
                 [](char background) { return background != 0 ? 0 : 1; });
  return SplitIntoSegments(grid, foreground);
}

std::vector<int> Renumbered(const std::vector<int>& labels, DisjointSets& sets) {
  std::vector<int> joined(labels.size());
  std::transform(labels.begin(), labels.end(), joined.begin(),
                 [&](int label) { return sets.Find(label); });
  return Renumbered(std::move(joined));
}

void RequireFewSegments(const std::vector<int>& segments) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  if (CountLabels(segments) <= kMax) return;
  throw TooComplex("more than 65535 segments, depth is mostly noise; raise voxels.size_m");
}

cv::Mat LabelImage(const VoxelGrid& grid, const std::vector<int>& labels) {
  InterruptionPoint();
  std::vector<std::uint16_t> label_of(labels.size() + 1, 0);  // the first for "no voxel"
  std::copy(labels.begin(), labels.end(), label_of.begin() + 1);
  cv::Mat image(grid.voxel_of_pixel.size(), CV_16UC1);
  for (int row = 0; row < image.rows; ++row) {
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    auto* label = image.ptr<std::uint16_t>(row);
    for (int col = 0; col < image.cols; ++col) label[col] = label_of[voxel[col] + 1];
  }
  return image;
}

cv::Mat LabelsWithin(const VoxelGrid& grid, const std::vector<int>& labels, const cv::Mat& mask) {
  cv::Mat image = LabelImage(grid, labels);
  InterruptionPoint();
  image.setTo(0, mask == 0);
  return image;
}

bool IsInterior(const cv::Mat& labels, int row, int col) {
  if (row == 0 || col == 0 || row == labels.rows - 1 || col == labels.cols - 1) return false;
  const std::uint16_t label = labels.at<std::uint16_t>(row, col);
  for (int r = row - 1; r <= row + 1; ++r) {
    const auto* line = labels.ptr<std::uint16_t>(r);
    for (int c = col - 1; c <= col + 1; ++c) {
      if (line[c] != label) return false;
    }
  }
  return true;
}

Lists<int> IndicesOfLabels(const std::vector<int>& labels) {
  InterruptionPoint();
  std::vector<std::size_t> sizes(CountLabels(labels) + 1, 0);
  for (const int label : labels) ++sizes[label];
  sizes[0] = 0;
  auto indices = Lists<int>::OfSizes(sizes);
  for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
    if (labels[i] != 0) indices.Put(labels[i], i);
  }
  return indices;
}

std::size_t CountLabels(const std::vector<int>& labels) {
  return labels.empty() ? 0
                        : static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end()));
}

}  // namespace fovea
