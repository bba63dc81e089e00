// Which predicted boxes are right.
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

namespace fovea::evaluation {

// For each true box the index of its predicted one, -1 where there is none: the most pairs with
// IoU > 0.5 that there can be, one to one.
std::vector<int> MatchBoxes(const std::vector<cv::Rect>& truth,
                            const std::vector<cv::Rect>& predicted);

}  // namespace fovea::evaluation
