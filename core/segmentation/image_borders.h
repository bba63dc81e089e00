// Which segments meet in the image, and which of them is in front.
#pragma once

#include <map>
#include <opencv2/core/mat.hpp>
#include <utility>

namespace fovea {

struct ImageBorder {
  int length_px = 0;       // pixels at which the two meet
  int first_in_front = 0;  // of them: the first is nearer by more than the step
  int second_in_front = 0;
};

// Borders by pair of labels, first < second; 0 = background takes no part.
using ImageBorders = std::map<std::pair<int, int>, ImageBorder>;

// `labels`: CV_16UC1; `points`: CV_32FC3, NaN = none. Segments meet where two pixels `reach_px`
// apart along a row or column have different labels, so that thin gaps are bridged; so are wider
// ones, up to 60 pixels in an image 640 wide, where nothing was measured: the shadow of what is in
// front. `step`: how much nearer is in front, as a share of the depth.
ImageBorders FindImageBorders(const cv::Mat& labels, const cv::Mat& points, int reach_px,
                              float step);

}  // namespace fovea
