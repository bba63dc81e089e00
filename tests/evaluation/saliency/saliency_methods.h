// The saliency methods that are compared.
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace fovea::evaluation {

struct SaliencyMethod {
  std::string name;
  // CV_8UC3, R first → CV_32FC1 of its size, larger = more salient. Holds no state.
  std::function<cv::Mat(const cv::Mat& color_rgb)> compute;
};

// strength: the paper's, at full resolution. strength_default: with the options of the default
// profile, on pixels; the detector computes it on blocks of them, which want depth.
// spectral_residual, fine_grained: OpenCV's. center: a Gaussian about the image centre, which shows
// how much the scores owe to people's habit of looking there.
std::vector<std::string> SaliencyMethodNames();

// Throws std::invalid_argument for a name that is none of these.
SaliencyMethod MakeSaliencyMethod(const std::string& name);

}  // namespace fovea::evaluation
