#include "tests/evaluation/generated/matching.h"

#include "tests/evaluation/regions.h"

namespace fovea::evaluation {

std::vector<std::pair<int, int>> MatchMasks(const cv::Mat& truth, const cv::Mat& answer,
                                            const cv::Mat& depth_m) {
  cv::Mat measured_truth = truth.clone(), measured_answer = answer.clone();
  const cv::Mat unmeasured = depth_m != depth_m;
  measured_truth.setTo(0, unmeasured);
  measured_answer.setTo(0, unmeasured);
  const std::vector<Region> rows = Regions(measured_truth), columns = Regions(measured_answer);
  const Eigen::MatrixXd shared = Intersections(measured_truth, rows, measured_answer, columns);
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const double both = shared(static_cast<int>(i), static_cast<int>(j));
      const double either = rows[i].num_pixels + columns[j].num_pixels - both;
      if (both > 0.5 * either) pairs.emplace_back(rows[i].label, columns[j].label);
    }
  }
  return pairs;
}

}  // namespace fovea::evaluation
