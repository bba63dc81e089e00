#include "tests/evaluation/box_matching.h"

#include "core/tracking/assignment.h"

namespace fovea::evaluation {

std::vector<int> MatchBoxes(const std::vector<cv::Rect>& truth,
                            const std::vector<cv::Rect>& predicted) {
  Eigen::MatrixXd right(truth.size(), predicted.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < predicted.size(); ++j) {
      const double common = (truth[i] & predicted[j]).area();
      const double all = truth[i].area() + predicted[j].area() - common;
      right(i, j) = common / all > 0.5 ? 1.0 : 0.0;
    }
  }
  std::vector<int> assigned = MaximumAssignment(right);
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    if (assigned[i] >= 0 && right(i, assigned[i]) == 0) assigned[i] = -1;
  }
  return assigned;
}

}  // namespace fovea::evaluation
