// Convex hulls of segments in the image: what one sees within them.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// Between them is what lies in their common convex hull but in the hull of neither alone. Returns
// the share of those pixels at which something is seen that is farther away than a surface through
// both would be: were the two one convex object, all of it would be hidden. 0 where nothing lies
// between. Pixels without depth count as hidden.
//
// `labels`: CV_16UC1; `points`: CV_32FC3 of the same size, NaN = none. Both labels must occur at
// three points that are not on a line. Cost: proportional to the image.
double ShareSeenThrough(const cv::Mat& labels, const cv::Mat& points, int a, int b);

}  // namespace fovea
