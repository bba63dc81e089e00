// What is done to a saliency map before it is scored.
#pragma once

#include <opencv2/core.hpp>

namespace fovea::evaluation {

// Shifts and stretches a CV_32FC1 map to [0, 1]; all 0 where it is flat.
cv::Mat ScaleToUnit(const cv::Mat& map);

// Gaussian blur of a CV_32FC1 map. A wide one works on a smaller map, with an error below
// 0.03 of the map's range at borders and steps. `border`: BORDER_CONSTANT takes 0 beyond the map,
// as MATLAB's imfilter does and with it the usual benchmarks; BORDER_REFLECT does not darken the
// border.
cv::Mat Blur(const cv::Mat& map, double sigma_px, cv::BorderTypes border);

// A Gaussian about the centre, 1 there, with standard deviations of `share` of width and height.
cv::Mat CenterPrior(const cv::Size& size, double share);

}  // namespace fovea::evaluation
