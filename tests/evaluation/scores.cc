#include "tests/evaluation/scores.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "tests/evaluation/assignment.h"

namespace fovea::evaluation {
namespace {

struct Region {
  int label = 0;
  int num_pixels = 0;
  cv::Rect bounds;
};

std::vector<Region> Regions(const cv::Mat& labels) {
  std::map<int, std::pair<int, cv::Vec4i>> found;  // label → size; left, top, right, bottom
  for (int y = 0; y < labels.rows; ++y) {
    const auto* row = labels.ptr<std::uint16_t>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] == 0) continue;
      auto& [size, box] = found.try_emplace(row[x], 0, cv::Vec4i(x, y, x, y)).first->second;
      ++size;
      box = {std::min(box[0], x), box[1], std::max(box[2], x), y};
    }
  }
  std::vector<Region> regions;
  for (const auto& [label, region] : found) {
    const auto& [size, box] = region;
    regions.push_back({label, size, cv::Rect({box[0], box[1]}, cv::Point(box[2] + 1, box[3] + 1))});
  }
  return regions;
}

Eigen::MatrixXd Intersections(const cv::Mat& truth, const std::vector<Region>& true_regions,
                              const cv::Mat& prediction,
                              const std::vector<Region>& predicted_regions) {
  std::map<int, int> row_of, column_of;
  for (const Region& region : true_regions) row_of.emplace(region.label, row_of.size());
  for (const Region& region : predicted_regions) column_of.emplace(region.label, column_of.size());
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(row_of.size(), column_of.size());
  for (int y = 0; y < truth.rows; ++y) {
    const auto* t = truth.ptr<std::uint16_t>(y);
    const auto* p = prediction.ptr<std::uint16_t>(y);
    for (int x = 0; x < truth.cols; ++x) {
      if (t[x] != 0 && p[x] != 0) ++counts(row_of[t[x]], column_of[p[x]]);
    }
  }
  return counts;
}

int MatchedBoxes(const std::vector<Region>& truth, const std::vector<Region>& prediction) {
  Eigen::MatrixXd overlaps(truth.size(), prediction.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < prediction.size(); ++j) {
      const double common = (truth[i].bounds & prediction[j].bounds).area();
      const double all = truth[i].bounds.area() + prediction[j].bounds.area() - common;
      overlaps(i, j) = common / all > 0.5 ? 1.0 : 0.0;
    }
  }
  const std::vector<int> assigned = MaximumAssignment(overlaps);
  int matched = 0;
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    if (assigned[i] >= 0 && overlaps(i, assigned[i]) > 0) ++matched;
  }
  return matched;
}

// 255 on the boundary pixels of one object, inside `window`.
cv::Mat Boundary(const cv::Mat& labels, int label, const cv::Rect& window) {
  const cv::Mat mask = labels(window) == label;
  cv::Mat padded;  // beyond the window the mask goes on as at its border
  cv::copyMakeBorder(mask, padded, 0, 1, 0, 1, cv::BORDER_REPLICATE);
  const auto shifted = [&](int dx, int dy) { return padded(cv::Rect({dx, dy}, mask.size())); };
  return (mask ^ shifted(1, 0)) | (mask ^ shifted(0, 1)) | (mask ^ shifted(1, 1));
}

int Hits(const cv::Mat& boundary, const cv::Mat& other, const cv::Mat& disk) {
  cv::Mat near;
  cv::dilate(other, near, disk);
  return cv::countNonZero(boundary & near);
}

cv::Mat Disk(int radius) {
  cv::Mat disk = cv::Mat::zeros(2 * radius + 1, 2 * radius + 1, CV_8UC1);
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      disk.at<std::uint8_t>(y + radius, x + radius) = x * x + y * y <= radius * radius;
    }
  }
  return disk;
}

Score BoundaryScore(const cv::Mat& truth, const std::vector<Region>& true_regions,
                    const cv::Mat& prediction, const std::vector<Region>& predicted_regions,
                    const std::vector<int>& assigned) {
  const cv::Rect image({0, 0}, truth.size());
  const int reach = static_cast<int>(std::ceil(0.003 * std::hypot(truth.cols, truth.rows)));
  const auto around = [&](const cv::Rect& bounds) {  // with room for boundary and reach
    const int margin = reach + 2;
    return (bounds - cv::Point(margin, margin) + cv::Size(2 * margin, 2 * margin)) & image;
  };
  int in_truth = 0, in_prediction = 0, hits_of_truth = 0, hits_of_predicted = 0;
  for (const Region& region : predicted_regions) {
    in_prediction += cv::countNonZero(Boundary(prediction, region.label, around(region.bounds)));
  }
  const cv::Mat disk = Disk(reach);
  for (std::size_t i = 0; i < true_regions.size(); ++i) {
    const Region& region = true_regions[i];
    in_truth += cv::countNonZero(Boundary(truth, region.label, around(region.bounds)));
    if (assigned[i] < 0) continue;
    const Region& match = predicted_regions[assigned[i]];
    const cv::Rect window = around(region.bounds | match.bounds);
    const cv::Mat of_truth = Boundary(truth, region.label, window);
    const cv::Mat of_match = Boundary(prediction, match.label, window);
    hits_of_truth += Hits(of_truth, of_match, disk);
    hits_of_predicted += Hits(of_match, of_truth, disk);
  }
  return MakeScore(hits_of_predicted, in_prediction, hits_of_truth, in_truth);
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
  scores.counts.matched_boxes = MatchedBoxes(true_regions, predicted_regions);
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
