#include "tests/evaluation/regions.h"

#include <algorithm>
#include <map>
#include <utility>

namespace fovea::evaluation {

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

}  // namespace fovea::evaluation
