// How much of a segment is cut off by what stands in front of it: little may show of an object that
// something hides, while little that stands in the open is mostly noise. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace fovea {

// Shares of the sides of a segment's pixels that face other pixels, by what is found there.
struct Seclusion {
  // Something nearer, also at the other side of its shadow, in which nothing is measured.
  double hidden = 0;
  // Something, object or background, that goes on at the same distance.
  double level = 0;
};

// `labels`: CV_16UC1; `depth_m`: CV_32FC1 as measured, nothing filled in, no positive number =
// none; `pixels`: those of one label above 0. Cost: proportional to the number of pixels.
Seclusion FindSeclusion(const cv::Mat& labels, const cv::Mat& depth_m,
                        const std::vector<cv::Point>& pixels);

}  // namespace fovea
