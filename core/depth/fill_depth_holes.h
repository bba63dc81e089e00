// Fills small holes in a depth image (paper section 1: "replacing the zero value pixels with the
// statistical mode of the surrounding 25 pixels").
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

struct DepthFillOptions {
  // How often the step is repeated, each time on the result of the one before; 0 … 10.
  // Repeating it to completion invents surfaces, so the default is once.
  int passes = 1;
  // The mode is taken as the densest interval of this width among the depths in the window, since
  // single millimetres hardly ever repeat; metres, 0 … 0.1.
  double bin_m = 0.01;
};

// Gives every pixel without depth the mode of its 5×5 neighbourhood: the median of the values in
// the densest interval of width bin_m; of several equally dense ones the farthest, as holes beside
// an edge belong to the background (the projector's shadow). Pixels whose neighbourhood is empty
// stay empty; measured pixels are not touched.
//
// `depth_m`: CV_32FC1, NaN = none. Returns the same type and size.
cv::Mat FillDepthHoles(const cv::Mat& depth_m, const DepthFillOptions& options = {});

}  // namespace fovea
