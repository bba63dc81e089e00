// Images at a lower resolution: a value for each square block of pixels. The last row and column of
// blocks may be cut.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace fovea {

// An image of blocks, as it stands for the pixels.
struct BlockImage {
  cv::Mat values;
  int size_px = 1;
};

// The average of every block of size_px × size_px pixels; what lies beyond the border repeats it.
// Any depth and number of channels.
cv::Mat ReduceByBlocks(const cv::Mat& image, int size_px);

// The average depth of every block over its pixels that have one. `depth_m`: CV_32FC1; NaN,
// infinite or not positive = none. Returns CV_32FC1, NaN for blocks without depth.
cv::Mat ReduceDepthByBlocks(const cv::Mat& depth_m, int size_px);

// The least depth of every block. `depth_m`: CV_32FC1, NaN = none. Returns CV_32FC1, NaN for blocks
// without depth.
cv::Mat NearestOfBlocks(const cv::Mat& depth_m, int size_px);

// Undoes the reduction in size: each value becomes a flat block. `map`: CV_8UC1,
// CV_32SC1 or CV_32FC1; `size`: of the image.
cv::Mat EnlargeBlocks(const cv::Mat& map, int size_px, const cv::Size& size);

}  // namespace fovea
