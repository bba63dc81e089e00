// How much a pixel stands out, in colour and in depth.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// The mean of both maps, each scaled to a maximum of 1. CV_32FC1 of one size, not negative.
cv::Mat MeanSaliency(const cv::Mat& color_saliency, const cv::Mat& depth_saliency);

}  // namespace fovea
