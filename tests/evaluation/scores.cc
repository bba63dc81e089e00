#include "tests/evaluation/scores.h"

#include <opencv2/core.hpp>
#include <vector>

#include "core/tracking/assignment.h"
#include "tests/evaluation/boundary_score.h"
#include "tests/evaluation/box_matching.h"
#include "tests/evaluation/regions.h"

namespace fovea::evaluation {
namespace {

std::vector<cv::Rect> BoundsOf(const std::vector<Region>& regions) {
  std::vector<cv::Rect> bounds;
  bounds.reserve(regions.size());
  for (const Region& region : regions) bounds.push_back(region.bounds);
  return bounds;
}

// Of each predicted label.
std::map<int, bool> MatchedBoxes(const std::vector<Region>& truth,
                                 const std::vector<Region>& prediction) {
  std::map<int, bool> matched;
  for (const Region& region : prediction) matched[region.label] = false;
  for (const int index : MatchBoxes(BoundsOf(truth), BoundsOf(prediction))) {
    if (index >= 0) matched[prediction[index].label] = true;
  }
  return matched;
}

double TotalPixels(const std::vector<Region>& regions) {
  double total = 0;
  for (const Region& region : regions) total += region.num_pixels;
  return total;
}

}  // namespace

Score MakeScore(double hits_of_predicted, double predicted, double hits_of_truth, double truth) {
  Score score;
  score.precision = predicted > 0 ? hits_of_predicted / predicted : 1.0;
  score.recall = truth > 0 ? hits_of_truth / truth : 1.0;
  const double sum = score.precision + score.recall;
  score.f = sum > 0 ? 2 * score.precision * score.recall / sum : 0.0;
  return score;
}

SceneScores ScoreScene(const cv::Mat& truth, const cv::Mat& prediction, const cv::Mat& valid) {
  cv::Mat t = truth.clone(), p = prediction.clone();
  t.setTo(0, valid == 0);
  p.setTo(0, valid == 0);
  const std::vector<Region> true_regions = Regions(t), predicted_regions = Regions(p);
  const Eigen::MatrixXd common = Intersections(t, true_regions, p, predicted_regions);

  Eigen::MatrixXd f(common.rows(), common.cols());  // 2·|A∩B| / (|A| + |B|)
  for (int i = 0; i < f.rows(); ++i) {
    for (int j = 0; j < f.cols(); ++j) {
      f(i, j) = 2 * common(i, j) / (true_regions[i].num_pixels + predicted_regions[j].num_pixels);
    }
  }
  const std::vector<int> assigned = MaximumAssignment(f);

  SceneScores scores;
  scores.counts.truth = static_cast<int>(true_regions.size());
  scores.counts.predicted = static_cast<int>(predicted_regions.size());
  scores.box_matched = MatchedBoxes(true_regions, predicted_regions);
  for (const auto& [label, matched] : scores.box_matched) scores.counts.matched_boxes += matched;
  double hits = 0;
  for (int i = 0; i < f.rows(); ++i) {
    if (assigned[i] < 0) continue;
    hits += common(i, assigned[i]);
    scores.counts.matched_75 += f(i, assigned[i]) > 0.75;
  }
  scores.overlap = MakeScore(hits, TotalPixels(predicted_regions), hits, TotalPixels(true_regions));
  scores.boundary = BoundaryScore(t, true_regions, p, predicted_regions, assigned);
  return scores;
}

}  // namespace fovea::evaluation
