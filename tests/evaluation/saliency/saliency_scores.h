// How well a saliency map foretells where people look.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace fovea::evaluation {

struct SaliencyScores {
  double auc = 0;  // AUC-Borji, 0.5 by chance
  double nss = 0;  // 0 by chance
  double cc = 0;   // 0 by chance
};

// Area under the ROC curve of "salient" for the map's values at fixations against those at other
// pixels, all in [0, 1]: thresholds 0, 0.1, … up to the largest value, ends (0, 0) and (1, 1),
// trapezoids. Neither may be empty.
double AreaUnderRoc(const std::vector<float>& at_fixations, const std::vector<float>& elsewhere);

// The mean of that area over 100 draws of as many pixels as there are fixations, with replacement,
// from the whole map, which is scaled to [0, 1] first (Borji et al. 2013). The same seed draws the
// same pixels. `map`: CV_32FC1. `fixations`: inside the map, not empty; so below.
double AucBorji(const cv::Mat& map, const std::vector<cv::Point>& fixations, std::uint64_t seed);

// Normalized scanpath saliency: the mean over the fixations of (S − mean) / std, where std divides
// by N − 1. 0 for a flat map.
double Nss(const cv::Mat& map, const std::vector<cv::Point>& fixations);

// Pearson's correlation of two maps, CV_32FC1 of one size. 0 where either is flat.
double Correlation(const cv::Mat& a, const cv::Mat& b);

// 1 at each fixation, blurred by a Gaussian: CV_32FC1.
cv::Mat FixationDensity(const std::vector<cv::Point>& fixations, const cv::Size& size,
                        double sigma_px);

}  // namespace fovea::evaluation
