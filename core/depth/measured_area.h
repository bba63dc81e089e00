// Where the camera sees: registered depth often leaves a margin of the colour image free.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace fovea {

// The image without the rows and columns at its ends of which less than half was measured. At most
// an eighth of the image at each end: what is wider is no margin but things too far away or cut
// out. `points`: CV_32FC3, NaN = none. Cost: proportional to the image.
cv::Rect MeasuredArea(const cv::Mat& points);

// True if a mask with these bounds ends where the image ends, or at a margin, whose edge is uneven
// by some pixels.
bool EndsWithArea(const cv::Rect& mask_bounds, const cv::Rect& measured_area,
                  const cv::Size& image);

}  // namespace fovea
