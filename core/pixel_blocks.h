// The resolution at which objects are looked for: square blocks of the camera's pixels. Voxels are
// what the method sees; pixels that are much finer than these take their time and find nothing more
// (docs/performance.md). Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct PixelBlocks {
  int edge_px = 1;
  cv::Size image;  // in pixels
  // What is one surface: the edge of a voxel, as a share of its distance.
  float max_step = 0.01F;

  // The pixel in the middle of a block, and the pixels of some blocks.
  cv::Point InPixels(const cv::Point& block) const;
  cv::Rect InPixels(const cv::Rect& blocks) const;
  cv::Rect PixelsOf(const cv::Point& block) const {
    const cv::Point first = block * edge_px;
    return {first.x, first.y, std::min(edge_px, image.width - first.x),
            std::min(edge_px, image.height - first.y)};
  }
  // What an image of the blocks says of each pixel.
  cv::Mat InPixels(const cv::Mat& of_blocks) const;
};

// As large as leaves 2.5 of them to the edge of a voxel (at 1 m, if these do not grow with the
// distance), but not larger than the image nor smaller than a pixel.
PixelBlocks BlocksOf(const RgbdFrame& frame, const VoxelOptions& voxels);

// A pixel for each block: of the mean colour and the least depth in it, which at the edge of an
// object is the object's; unseen where the camera sees nothing of it. `depth_m`: in place of that
// of `frame`.
RgbdFrame InBlocks(const RgbdFrame& frame, const cv::Mat& depth_m, const PixelBlocks& blocks);

// A copy of `depth_m` (CV_32FC1, NaN = none) in which pixels that have none get that of their
// block, of those blocks that are not 0 in `which` (CV_8UC1); itself if there are no such blocks.
cv::Mat FillFromBlocks(const cv::Mat& depth_m, const cv::Mat& depth_of_blocks, const cv::Mat& which,
                       const PixelBlocks& blocks);

// The label of each pixel: that of its block or, where the surface that this shows is not the
// pixel's, of the block around it whose surface is the nearest to it; 0 where none is near or the
// pixel has no depth up to `max_depth_m`. `label_of_block` (CV_16UC1) and `depth_of_blocks`
// (CV_32FC1) are of the blocks, `depth_m` (CV_32FC1, NaN = none) of the pixels. Returns CV_16UC1.
// Cost: proportional to what is labelled.
cv::Mat LabelsOfPixels(const cv::Mat& label_of_block, const cv::Mat& depth_of_blocks,
                       const cv::Mat& depth_m, double max_depth_m, const PixelBlocks& blocks);

// The points of some pixels without a label, evenly spread: of every third block in each direction
// that in its middle. Blocks, which have the least depth in them, lie nearer to the camera, by half
// of a block where a surface slopes and by what noise lifts.
std::vector<Eigen::Vector3f> UnlabelledPoints(const PixelPoints& points, const cv::Mat& labels,
                                              const PixelBlocks& blocks);

}  // namespace fovea
