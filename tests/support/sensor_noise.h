// What sensors have in common: noise, and how edges suffer. Depth images are CV_32FC1 in metres,
// NaN = none.
#pragma once

#include <opencv2/core/mat.hpp>

#include "tests/support/random.h"

namespace fovea::scenes {

// Gaussian noise (CV_32FC1) of mean 0 and standard deviation 1, correlated over about `sigma_px`;
// independent pixels for 0.
cv::Mat Noise(const cv::Size& size, double sigma_px, Random& random);

// CV_8UC1, 255 where depth jumps by more than 2 cm + 1 % within `window`, or ends.
cv::Mat DepthEdges(const cv::Mat& depth_m, const cv::Size& window);

// Removes depth in a band of changing width around the edges, `low` to `high` pixels to either
// side.
void ErodeEdges(cv::Mat& depth_m, const cv::Mat& edges, double low, double high, Random& random);

constexpr double kStereoBaseline_m = 0.05;
constexpr double kStereoNoise_px = 0.08;  // standard deviation of the disparity

// The depth as active stereo measures it: edges go to what is nearer, and the noise is correlated
// over some pixels.
cv::Mat WithStereoNoise(const cv::Mat& depth_m, double focal_length_px, Random& random);

// The depth as a wide matching window and the camera's own filters leave it: what is nearer reaches
// some 8 px beyond its edges, sloping down to what is behind it where that is close.
cv::Mat WithHalos(const cv::Mat& depth_m, double focal_length_px, Random& random);

// The depth as seen through pixels that wander by half a pixel (standard deviation).
cv::Mat WithLateralNoise(const cv::Mat& depth_m, Random& random);

}  // namespace fovea::scenes
