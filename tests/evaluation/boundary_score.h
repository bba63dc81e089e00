// How well the outlines of assigned objects agree.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "tests/evaluation/regions.h"
#include "tests/evaluation/scores.h"

namespace fovea::evaluation {

// The boundary score of ScoreScene. `assigned`: the index of the predicted region of each true
// one, -1 for none.
Score BoundaryScore(const cv::Mat& truth, const std::vector<Region>& true_regions,
                    const cv::Mat& prediction, const std::vector<Region>& predicted_regions,
                    const std::vector<int>& assigned);

}  // namespace fovea::evaluation
