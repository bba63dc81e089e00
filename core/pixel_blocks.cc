#include "core/pixel_blocks.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/types/blocks.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kBlocksPerVoxel = 2.5;

CameraIntrinsics InBlocks(const CameraIntrinsics& camera, int edge_px) {
  return {camera.fx_px / edge_px, camera.fy_px / edge_px, (camera.cx_px + 0.5) / edge_px - 0.5,
          (camera.cy_px + 0.5) / edge_px - 0.5};
}

// Of the blocks around one, that of the surface nearest to a depth; -1: none is near.
int VoxelAround(const cv::Mat& voxel_of_block, const cv::Mat& depth_of_blocks,
                const cv::Point& block, float depth, float max_step) {
  const cv::Rect around =
      cv::Rect(block - cv::Point(1, 1), cv::Size(3, 3)) & cv::Rect({}, voxel_of_block.size());
  int voxel = -1;
  float least = max_step * depth;
  for (int row = around.y; row < around.br().y; ++row) {
    for (int col = around.x; col < around.br().x; ++col) {
      const float step = std::abs(depth_of_blocks.at<float>(row, col) - depth);
      if (!(step < least)) continue;
      least = step;
      voxel = voxel_of_block.at<int>(row, col);
    }
  }
  return voxel;
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

cv::Mat FillFromBlocks(const cv::Mat& depth_m, const cv::Mat& depth_of_blocks,
                       const PixelBlocks& blocks) {
  InterruptionPoint();
  const cv::Mat is_none =
      ~(depth_m == depth_m);  // unlike != in OpenCV, whose vectors call NaN equal
  cv::Mat filled = depth_m.clone();
  blocks.InPixels(depth_of_blocks).copyTo(filled, is_none);
  return filled;
}

cv::Mat VoxelsOfPixels(const cv::Mat& voxel_of_block, const cv::Mat& depth_of_blocks,
                       const cv::Mat& depth_m, const PixelBlocks& blocks) {
  cv::Mat result(depth_m.size(), CV_32SC1);
  for (int row = 0; row < result.rows; ++row) {
    InterruptionPoint();
    const int block_row = row / blocks.edge_px;
    const float* own_depth = depth_of_blocks.ptr<float>(block_row);
    const int* own_voxel = voxel_of_block.ptr<int>(block_row);
    const float* depth = depth_m.ptr<float>(row);
    int* voxel = result.ptr<int>(row);
    for (int col = 0; col < result.cols; ++col) {
      const int block = col / blocks.edge_px;
      const bool is_beside = std::abs(depth[col] - own_depth[block]) > blocks.max_step * depth[col];
      voxel[col] = is_beside ? VoxelAround(voxel_of_block, depth_of_blocks, {block, block_row},
                                           depth[col], blocks.max_step)
                             : own_voxel[block];
    }
  }
  return result;
}

}  // namespace fovea
