// Masks grown and shrunk by small squares, without the dozen objects that OpenCV's filters make for
// each image.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// Gives each pixel the largest value of those up to `reach_px` away along both axes; there are none
// outside of the image. `image`: CV_8UC1 or CV_16UC1.
void TakeLargestAround(int reach_px, cv::Mat& image);

// The same with the least.
void TakeLeastAround(int reach_px, cv::Mat& image);

// One after the other: fills gaps up to twice the reach wide.
void CloseGaps(int reach_px, cv::Mat& image);

}  // namespace fovea
