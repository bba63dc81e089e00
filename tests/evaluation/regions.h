// The objects of a label image.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace fovea::evaluation {

struct Region {
  int label = 0;
  int num_pixels = 0;
  cv::Rect bounds;  // smallest upright rectangle around its pixels
};

// The regions of `labels` (CV_16UC1, 0 = none) by rising label.
std::vector<Region> Regions(const cv::Mat& labels);

// Numbers of pixels that each true region (row) shares with each predicted one (column).
Eigen::MatrixXd Intersections(const cv::Mat& truth, const std::vector<Region>& true_regions,
                              const cv::Mat& prediction,
                              const std::vector<Region>& predicted_regions);

}  // namespace fovea::evaluation
