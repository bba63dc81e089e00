// Colours of frames that are darker than what is known of colours. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

struct WellExposed {
  cv::Mat color_rgb;      // CV_8UC3
  bool is_blank = false;  // nothing is told apart in it: it is one grey
};

// `color_rgb`: CV_8UC3, R first, not empty. As it is where its light places are as bright as those
// of usual frames, else brightened by one factor until they are; blank where it is black, white, of
// one colour, or noise alone. Cost: a pass over the image.
WellExposed Expose(const cv::Mat& color_rgb);

}  // namespace fovea
