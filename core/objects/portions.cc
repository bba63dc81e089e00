#include "core/objects/portions.h"

#include <algorithm>
#include <numeric>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

struct SalientPart {
  double saliency = 0;  // sum over its pixels
  double num_pixels = 0;
  std::size_t num_voxels = 0;
};

std::vector<SalientPart> CollectParts(const VoxelGrid& grid, const std::vector<int>& part_of_voxel,
                                      const cv::Mat& saliency) {
  std::vector<SalientPart> parts(CountLabels(part_of_voxel) + 1);
  for (const int part : part_of_voxel) ++parts[part].num_voxels;
  for (int row = 0; row < saliency.rows; ++row) {
    InterruptionPoint();
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const float* value = saliency.ptr<float>(row);
    for (int col = 0; col < saliency.cols; ++col) {
      if (voxel[col] < 0) continue;
      SalientPart& part = parts[part_of_voxel[voxel[col]]];
      part.saliency += value[col];
      ++part.num_pixels;
    }
  }
  return parts;
}

// The parts, without the background, by falling mean saliency.
std::vector<int> Order(const std::vector<SalientPart>& parts) {
  std::vector<int> order(parts.size() - 1);
  std::iota(order.begin(), order.end(), 1);
  const auto mean = [&](int part) { return parts[part].saliency / parts[part].num_pixels; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mean(a) > mean(b); });
  return order;
}

}  // namespace

std::vector<std::vector<char>> SalientPortions(const VoxelGrid& grid,
                                               const std::vector<char>& is_background,
                                               const cv::Mat& saliency, int num_portions) {
  const std::vector<int> part_of_voxel = PartsOfForeground(grid, is_background);
  const std::vector<SalientPart> parts = CollectParts(grid, part_of_voxel, saliency);
  const std::size_t num_voxels = part_of_voxel.size() - parts.front().num_voxels;
  std::vector<int> portion_of_part(parts.size(), -1);
  std::size_t num_before = 0;
  int last = 0;
  for (const int part : Order(parts)) {
    // That in which its middle lies.
    const std::size_t middle = num_before + parts[part].num_voxels / 2;
    last = std::max(last, static_cast<int>(middle * static_cast<std::size_t>(num_portions) /
                                           std::max<std::size_t>(1, num_voxels)));
    portion_of_part[part] = last;
    num_before += parts[part].num_voxels;
  }
  std::vector<std::vector<char>> portions;
  for (int portion = 0; portion <= last; ++portion) {
    std::vector<char> outside(part_of_voxel.size());
    bool any = false;
    for (std::size_t v = 0; v < outside.size(); ++v) {
      outside[v] = portion_of_part[part_of_voxel[v]] == portion ? 0 : 1;
      any |= outside[v] == 0;
    }
    if (any || (portion == last && portions.empty())) portions.push_back(std::move(outside));
  }
  return portions;
}

}  // namespace fovea
