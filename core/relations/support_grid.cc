#include "core/relations/support_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kMaxCells = 400;  // along a side
constexpr int kGapCells = 2;      // that are closed; around the grid, too, so that its rim stays

bool IsSet(const cv::Vec3f& p) { return !std::isnan(p[2]); }

}  // namespace

SupportGrid::SupportGrid(const cv::Mat& points, const Support& support,
                         const std::vector<DetectedObject>& objects, float height_m,
                         float tolerance_m)
    : surface_(support.surface), axes_(LevelAxesAlongView(support.surface.normal)) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  std::vector<Eigen::Vector3f> on, above;
  Eigen::Vector2f low = Eigen::Vector2f::Constant(kHuge), high = -low;
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    for (const auto* p = points.ptr<cv::Vec3f>(row); p < points.ptr<cv::Vec3f>(row) + points.cols;
         ++p) {
      if (!IsSet(*p)) continue;
      const Eigen::Vector3f point((*p)[0], (*p)[1], (*p)[2]);
      const float height = surface_.HeightOf(point);
      if (height > tolerance_m && height < height_m) above.push_back(point);
      if (std::abs(height) > tolerance_m || !support.footprint.Covers(point)) continue;
      on.push_back(point);
      low = low.cwiseMin(axes_ * point);
      high = high.cwiseMax(axes_ * point);
    }
  }
  if (on.empty()) low = high = Eigen::Vector2f::Zero();
  cell_m_ = std::max(cell_m_, (high - low).maxCoeff() / kMaxCells);
  origin_ = low - Eigen::Vector2f::Constant(kGapCells * cell_m_);
  const Eigen::Vector2i extent = ((high - low) / cell_m_).cast<int>().array() + 2 * kGapCells + 1;
  free_ = cv::Mat::zeros(extent.y(), extent.x(), CV_8UC1);
  const cv::Rect grid({0, 0}, free_.size());
  for (const Eigen::Vector3f& point : on) {
    const cv::Point cell = CellOf(point);
    if (grid.contains(cell)) free_.at<uchar>(cell) = 255;
  }
  // Far surfaces are sampled thinly.
  cv::morphologyEx(free_, free_, cv::MORPH_CLOSE, cv::Mat::ones(5, 5, CV_8UC1), {-1, -1}, 1,
                   cv::BORDER_CONSTANT, cv::Scalar(0));
  for (const Eigen::Vector3f& point : above) {
    const cv::Point cell = CellOf(point);
    if (grid.contains(cell)) free_.at<uchar>(cell) = 0;
  }
  for (const DetectedObject& object : objects) {
    const float bottom = surface_.HeightOf(object.box.center) - object.box.size_m.z() / 2;
    if (bottom < height_m && bottom + object.box.size_m.z() > tolerance_m) BlockBox(object.box);
  }
}

cv::Point2f SupportGrid::CellOf(const Eigen::Vector3f& point) const {
  const Eigen::Vector2f cell = (axes_ * point - origin_) / cell_m_;
  return {cell.x(), cell.y()};
}

Eigen::Vector3f SupportGrid::PointAt(const cv::Point2f& cell) const {
  const Eigen::Vector2f place = origin_ + cell_m_ * Eigen::Vector2f(cell.x, cell.y);
  return axes_.transpose() * place - surface_.offset_m * surface_.normal;
}

void SupportGrid::BlockBox(const OrientedBox& box) {
  const Eigen::Vector3f u = box.rotation.col(0) * (box.size_m.x() / 2),
                        v = box.rotation.col(1) * (box.size_m.y() / 2);
  std::vector<cv::Point> corners;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const cv::Point2f corner =
        CellOf(box.center + static_cast<float>(a) * u + static_cast<float>(b) * v);
    // Far beside the grid all is the same, and a box may be anywhere.
    corners.emplace_back(cvRound(std::clamp(corner.x, -2 * kMaxCells, 3 * kMaxCells)),
                         cvRound(std::clamp(corner.y, -2 * kMaxCells, 3 * kMaxCells)));
  }
  cv::fillConvexPoly(free_, corners, cv::Scalar(0));
}

}  // namespace fovea
