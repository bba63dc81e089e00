// One seed on every true object: how far the segmentation is from its limit.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "tests/evaluation/dataset.h"
#include "tests/evaluation/detection_run.h"

namespace fovea::evaluation {

// For each object of the scene, in the order of their labels, the pixel of its mask nearest to the
// mask's centroid that has depth in the frame; objects without depth have none.
std::vector<cv::Point> TrueSeeds(const Scene& scene);

// Our detector, with those seeds instead of the salient positions. Throws std::invalid_argument for
// options of a profile that takes none ("paper" does).
DetectFunction DetectFromTrueSeeds(const DetectorOptions& options);

}  // namespace fovea::evaluation
