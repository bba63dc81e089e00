// Depth saliency by anisotropic centre-surround difference (Ju et al. 2014), which the paper
// employs in section 3.1.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/saliency/line_contrast.h"

namespace fovea {

struct DepthSaliencyOptions {
  // The depth image is reduced by this factor first (average) and the map enlarged afterwards; 1 …
  // 8. Ju: 1.
  int downscale = 1;
  // Length of the scan lines as a share of the image diagonal. Ju: 0.4.
  double line_length = 0.4;
  // Distance between samples on a scan line, in pixels of the depth image. Ju: 5.
  int line_step_px = 5;
  // Weights the farther half of the pixels down (Ju's depth prior).
  bool depth_prior = true;
  // Weights pixels down towards the image border; hurts objects off the centre.
  bool center_prior = false;
};

// How far each pixel stands out towards the camera from its surroundings: the sum over eight
// directions of its nearness (1/depth) minus the least nearness along a scan line. Pixels without
// depth are unknown, not far: they count in no minimum. The map's maximum is 1 before the priors.
//
// `depth_m`: CV_32FC1, not empty, metres along z, NaN = none. Returns CV_32FC1 of its size in
// [0, 1]; 0 where there is no depth; all 0 where no pixel has depth or nothing stands out.
cv::Mat DepthSaliency(const cv::Mat& depth_m, const DepthSaliencyOptions& options = {},
                      const Contrast& contrast = ContrastOfPixels);

}  // namespace fovea
