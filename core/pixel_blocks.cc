#include "core/pixel_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/blocks.h"
#include "core/types/interruption.h"
#include "core/types/squares.h"

namespace fovea {
namespace {

constexpr double kBlocksPerVoxel = 2.5;

CameraIntrinsics InBlocks(const CameraIntrinsics& camera, int edge_px) {
  return {camera.fx_px / edge_px, camera.fy_px / edge_px, (camera.cx_px + 0.5) / edge_px - 0.5,
          (camera.cy_px + 0.5) / edge_px - 0.5};
}

// Of the blocks around one, that of the surface nearest to a depth; 0: none is near.
std::uint16_t LabelAround(const cv::Point& block, const cv::Mat& labels,
                          const cv::Mat& depth_of_blocks, float depth, float max_step) {
  const cv::Rect blocks =
      cv::Rect(block - cv::Point(1, 1), cv::Size(3, 3)) & cv::Rect({}, labels.size());
  std::uint16_t label = 0;
  float least = max_step * depth;
  for (int row = blocks.y; row < blocks.br().y; ++row) {
    for (int col = blocks.x; col < blocks.br().x; ++col) {
      const float step = std::abs(depth_of_blocks.at<float>(row, col) - depth);
      if (!(step < least)) continue;
      least = step;
      label = labels.at<std::uint16_t>(row, col);
    }
  }
  return label;
}

// Of one block; pixels without depth up to `limit_m` keep what they have.
void LabelPixelsOf(const cv::Point& block, const PixelBlocks& blocks, const cv::Mat& label_of_block,
                   const cv::Mat& depth_of_blocks, const cv::Mat& depth_m, float limit_m,
                   cv::Mat& labels) {
  const auto own_label = label_of_block.at<std::uint16_t>(block);
  const float own_depth = depth_of_blocks.at<float>(block);
  const cv::Rect pixels = blocks.PixelsOf(block);
  for (int row = pixels.y; row < pixels.br().y; ++row) {
    const float* depth = depth_m.ptr<float>(row);
    auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = pixels.x; col < pixels.br().x; ++col) {
      if (!(depth[col] <= limit_m)) continue;
      const bool is_own = std::abs(depth[col] - own_depth) <= blocks.max_step * depth[col];
      label[col] =
          is_own ? own_label
                 : LabelAround(block, label_of_block, depth_of_blocks, depth[col], blocks.max_step);
    }
  }
}

}  // namespace

cv::Point PixelBlocks::InPixels(const cv::Point& block) const {
  const cv::Point middle = block * edge_px + cv::Point(edge_px / 2, edge_px / 2);
  return {std::min(middle.x, image.width - 1), std::min(middle.y, image.height - 1)};
}

cv::Rect PixelBlocks::InPixels(const cv::Rect& blocks) const {
  return cv::Rect(blocks.tl() * edge_px, blocks.size() * edge_px) & cv::Rect({}, image);
}

cv::Mat PixelBlocks::InPixels(const cv::Mat& of_blocks) const {
  return EnlargeBlocks(of_blocks, edge_px, image);
}

PixelBlocks BlocksOf(const RgbdFrame& frame, const VoxelOptions& voxels) {
  const cv::Size size = frame.depth_m.size();
  const double voxel_px = voxels.size_m * std::min(frame.intrinsics.fx_px, frame.intrinsics.fy_px);
  const double largest = std::min(size.width, size.height);
  return {static_cast<int>(std::clamp(voxel_px / kBlocksPerVoxel, 1.0, largest)), size,
          static_cast<float>(voxels.size_m)};
}

RgbdFrame InBlocks(const RgbdFrame& frame, const cv::Mat& depth_m, const PixelBlocks& blocks) {
  const int edge_px = blocks.edge_px;
  InterruptionPoint();
  const cv::Mat color = ReduceByBlocks(frame.color_rgb, edge_px);
  cv::Mat unseen;
  if (!frame.unseen.empty()) unseen = ReduceByBlocks(frame.unseen != 0, edge_px) == 255;
  return {color, NearestOfBlocks(depth_m, edge_px), InBlocks(frame.intrinsics, edge_px),
          frame.gravity, unseen};
}

cv::Mat FillFromBlocks(const cv::Mat& depth_m, const cv::Mat& depth_of_blocks, const cv::Mat& which,
                       const PixelBlocks& blocks) {
  InterruptionPoint();
  std::vector<cv::Point> filling;
  cv::findNonZero(which, filling);
  if (filling.empty()) return depth_m;
  cv::Mat filled = depth_m.clone();
  for (const cv::Point& block : filling) {
    const float depth_of_block = depth_of_blocks.at<float>(block);
    const cv::Rect pixels = blocks.PixelsOf(block);
    for (int row = pixels.y; row < pixels.br().y; ++row) {
      const float* depth = depth_m.ptr<float>(row);
      float* out = filled.ptr<float>(row);
      for (int col = pixels.x; col < pixels.br().x; ++col) {
        if (std::isnan(depth[col])) out[col] = depth_of_block;
      }
    }
  }
  return filled;
}

cv::Mat LabelsOfPixels(const cv::Mat& label_of_block, const cv::Mat& depth_of_blocks,
                       const cv::Mat& depth_m, double max_depth_m, const PixelBlocks& blocks) {
  const auto limit = static_cast<float>(max_depth_m);
  cv::Mat labels = cv::Mat::zeros(depth_m.size(), CV_16UC1);
  cv::Mat any_around = label_of_block.clone();
  TakeLargestAround(1, any_around);
  for (cv::Point block; block.y < label_of_block.rows; ++block.y) {
    InterruptionPoint();
    for (block.x = 0; block.x < label_of_block.cols; ++block.x) {
      if (any_around.at<std::uint16_t>(block) == 0) continue;
      LabelPixelsOf(block, blocks, label_of_block, depth_of_blocks, depth_m, limit, labels);
    }
  }
  return labels;
}

std::vector<Eigen::Vector3f> UnlabelledPoints(const PixelPoints& points, const cv::Mat& labels,
                                              const PixelBlocks& blocks) {
  constexpr int kStep = 3;
  const std::size_t step_px = static_cast<std::size_t>(kStep) * blocks.edge_px;
  std::vector<Eigen::Vector3f> unlabelled;
  unlabelled.reserve((labels.rows / step_px + 1) * (labels.cols / step_px + 1));
  for (int row = blocks.edge_px / 2; row < labels.rows; row += kStep * blocks.edge_px) {
    for (int col = blocks.edge_px / 2; col < labels.cols; col += kStep * blocks.edge_px) {
      const bool has_depth = !std::isnan(points.Depth_m().at<float>(row, col));
      if (has_depth && labels.at<std::uint16_t>(row, col) == 0) {
        unlabelled.push_back(points.At(row, col));
      }
    }
  }
  return unlabelled;
}

}  // namespace fovea
