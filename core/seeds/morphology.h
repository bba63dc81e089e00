// Grey-scale morphology on floating-point maps: the steps of opening by reconstruction and the
// search for flat peaks (Vincent 1993; paper section 3.2).
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// Minimum of `map` over the disk of pixels at distance ≤ radius_px; pixels outside the image do
// not count. `map`: CV_32FC1. Returns the same type and size. Radius 0 copies.
cv::Mat ErodeByDisk(const cv::Mat& map, int radius_px);

// Morphological reconstruction by dilation of `marker` under `mask` with 8 neighbours: the limit
// of dilating the marker by 3×3 and taking the minimum with the mask. Both CV_32FC1 of one size,
// not negative; marker ≤ mask everywhere (larger marker values are lowered to the mask's).
cv::Mat ReconstructByDilation(const cv::Mat& marker, const cv::Mat& mask);

// Connected (8 neighbours) plateaus of equal value whose neighbours are all lower. Returns
// CV_32SC1: 0 = none, 1 … n = number of the plateau in row-major order of its first pixel. A
// constant map has no maximum. `map`: CV_32FC1 without NaN.
cv::Mat LabelRegionalMaxima(const cv::Mat& map);

}  // namespace fovea
