// Where the camera sees: registered depth often leaves a margin of the colour image free, and an
// undistorted image may show less than its rectangle.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "core/types/pixel_runs.h"

namespace fovea {

class SeenArea {
 public:
  // `depth_m`: CV_32FC1, or CV_32FC3 with the depth last; NaN = none; `unseen`: RgbdFrame::unseen.
  // Cost: proportional to the ends of the image.
  SeenArea(const cv::Mat& depth_m, const cv::Mat& unseen);

  // The image without the rows and columns at its ends of which less than half was measured. At
  // most an eighth of the image at each end: what is wider is no margin but things too far away or
  // cut out.
  const cv::Rect& bounds() const { return bounds_; }

  // Any pixel, in the image or not.
  bool Contains(const cv::Point& pixel) const;

  // Whether a mask ends where the image ends, or at a margin, whose edge is uneven by some pixels.
  bool CutsOff(const PixelRuns& mask) const;

 private:
  cv::Size image_;
  cv::Rect bounds_;
  cv::Mat unseen_, beside_unseen_;  // CV_8UC1, or empty
};

}  // namespace fovea
