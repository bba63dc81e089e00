// What one sees beyond the border of a segment.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace fovea {

// The depth of the first thing measured beyond a pixel in a direction, within 30 pixels (at a width
// of 640, scaled with it), which is wider than the shadow of most things. NaN where nothing was
// measured or the image ends; none where the pixel's own segment goes on, so that its border is not
// there.
//
// `labels`: CV_16UC1; `depth_m`: CV_32FC1, no positive number = none; `direction`: unit vector;
// `edge_px`: pixels next to the border that do not count, since sensors mix depths there.
std::optional<float> DepthBeyond(const cv::Mat& labels, const cv::Mat& depth_m,
                                 const cv::Point& pixel, const cv::Point2f& direction, int edge_px);

}  // namespace fovea
