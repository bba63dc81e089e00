// Colours of frames that are darker than what is known of colours. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// `color_rgb`: CV_8UC3, R first, not empty. Returns it as it is where its light places are as
// bright as those of usual frames, else brightened by one factor until they are; and one grey where
// nothing is told apart in it: black frames, white ones, and noise alone. Cost: a pass over the
// image.
cv::Mat WellExposed(const cv::Mat& color_rgb);

}  // namespace fovea
