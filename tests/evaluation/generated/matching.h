// Which masks belong together.
#pragma once

#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

namespace fovea::evaluation {

// Pairs of labels, of the truth and of the answer, whose masks have an IoU > 0.5 (so no mask is in
// two pairs), by rising true label. Both CV_16UC1, 0 = none; only where `depth_m` (CV_32FC1) is a
// number.
std::vector<std::pair<int, int>> MatchMasks(const cv::Mat& truth, const cv::Mat& answer,
                                            const cv::Mat& depth_m);

}  // namespace fovea::evaluation
