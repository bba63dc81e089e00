#include "tests/evaluation/boundary_score.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace fovea::evaluation {
namespace {

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

}  // namespace

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

}  // namespace fovea::evaluation
