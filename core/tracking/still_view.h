// Whether two frames were taken from the same place.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// A frame, small: what is seen of the scene and where it may move.
struct SmallView {
  cv::Mat gray;     // CV_32FC1, 160 wide and 3 to 640 high, smoothed
  cv::Mat movable;  // CV_8UC1, 255 on objects and near them
};

// `labels`: CV_16UC1 of the frame's size, 0 = background.
SmallView SmallViewOf(const RgbdFrame& frame, const cv::Mat& labels);

// True where the images outside of objects are shifted, turned and scaled against each other by
// less than a third of a pixel at 640 pixels of width anywhere, as least squares over their
// gradients have it (Lucas and Kanade 1981) besides a change of exposure, without what these leave
// unexplained, of which there may be a tenth. False where there is too little contrast to tell.
// 1.2 ms.
bool IsSameView(const SmallView& a, const SmallView& b);

}  // namespace fovea
