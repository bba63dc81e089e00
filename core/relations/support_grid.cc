#include "core/relations/support_grid.h"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kMaxCells = 400;  // along a side
constexpr int kGapCells = 2;      // that are closed; around the grid, too, so that its rim stays
constexpr int kMaxSpeckCells = 2;

// How many pixels that look at each cell saw the support there, and how many did not; CV_32SC1.
struct SightCounts {
  cv::Mat seen, not_seen;
};

// `cells_of_pixels`: of homogeneous pixels; those that do not look at the plane have none above 0.
SightCounts CountSights(const cv::Mat& sights, const Eigen::Matrix3f& cells_of_pixels,
                        const cv::Size& grid) {
  SightCounts counts{cv::Mat::zeros(grid, CV_32SC1), cv::Mat::zeros(grid, CV_32SC1)};
  const auto width = static_cast<float>(grid.width), height = static_cast<float>(grid.height);
  const Eigen::Vector3f step = cells_of_pixels.col(0);
  // What looks beside all that was seen looks beside the grid.
  const cv::Rect image = cv::boundingRect(sights == static_cast<int>(Sight::kSeen));
  for (int row = image.y; row < image.br().y; ++row) {
    InterruptionPoint();
    const auto* sight = sights.ptr<Sight>(row);
    const Eigen::Vector3f first =
        cells_of_pixels.col(1) * static_cast<float>(row) + cells_of_pixels.col(2);
    for (int col = image.x; col < image.br().x; ++col) {
      if (sight[col] == Sight::kNothing) continue;
      const Eigen::Vector3f cell = first + step * static_cast<float>(col);
      if (!(cell.z() > 0)) continue;
      const float share = 1 / cell.z(), x = cell.x() * share + 0.5F, y = cell.y() * share + 0.5F;
      if (!(x >= 0 && y >= 0 && x < width && y < height)) continue;
      cv::Mat& count = sight[col] == Sight::kSeen ? counts.seen : counts.not_seen;
      ++count.ptr<int>(static_cast<int>(y))[static_cast<int>(x)];
    }
  }
  return counts;
}

void RemoveSpecks(cv::Mat& set) {
  cv::Mat parts, statistics, centroids;
  const int num_parts = cv::connectedComponentsWithStats(set, parts, statistics, centroids);
  for (int part = 1; part < num_parts; ++part) {
    const int* of_part = statistics.ptr<int>(part);
    if (of_part[cv::CC_STAT_AREA] > kMaxSpeckCells) continue;
    const cv::Rect box(of_part[cv::CC_STAT_LEFT], of_part[cv::CC_STAT_TOP],
                       of_part[cv::CC_STAT_WIDTH], of_part[cv::CC_STAT_HEIGHT]);
    set(box).setTo(0, parts(box) == part);
  }
}

// Far surfaces are sampled thinly: what is between two cells is as they are.
cv::Mat WithoutGaps(const cv::Mat& set) {
  constexpr int kEdge = 2 * kGapCells + 1;
  cv::Mat closed;
  cv::morphologyEx(set, closed, cv::MORPH_CLOSE, cv::Mat::ones(kEdge, kEdge, CV_8UC1), {-1, -1}, 1,
                   cv::BORDER_CONSTANT, cv::Scalar(0));
  return closed;
}

}  // namespace

SupportGrid::SupportGrid(const ViewedScene& scene, const Support& support,
                         const std::vector<DetectedObject>& objects, float height_m,
                         const SupportOptions& options)
    : surface_(support.surface), axes_(LevelAxesAlongView(support.surface.normal)) {
  const std::vector<char> in_the_way = StandInTheWay(surface_, objects, height_m);
  const SupportView view = LookAt(scene, support, axes_, in_the_way, height_m, options);
  const Eigen::Vector2f size = view.end - view.begin;
  cell_m_ = std::max(cell_m_, size.maxCoeff() / kMaxCells);
  origin_ = view.begin - Eigen::Vector2f::Constant(kGapCells * cell_m_);
  const Eigen::Vector2i extent = (size / cell_m_).cast<int>().array() + 2 * kGapCells + 1;
  free_.create(extent.y(), extent.x(), CV_8UC1);
  FreeWhatIsSeen(view, scene.frame.intrinsics);
  for (const Eigen::Vector3f& point : view.in_the_way) BlockPoint(point);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (in_the_way[i] != 0) BlockBox(objects[i].box);
  }
}

void SupportGrid::FreeWhatIsSeen(const SupportView& view, const CameraIntrinsics& intrinsics) {
  const cv::Rect grid({0, 0}, free_.size());
  SightCounts counts = CountSights(view.sights, CellsOfPixels(intrinsics), grid.size());
  for (const Eigen::Vector3f& point : view.low) {
    const cv::Point cell = CellOf(point);
    if (grid.contains(cell)) ++counts.not_seen.at<int>(cell);
  }
  const cv::Mat mostly_not = counts.not_seen > counts.seen;
  const cv::Mat seen = (counts.seen > 0) & ~mostly_not;
  cv::Mat not_seen = WithoutGaps(mostly_not) & ~seen;
  RemoveSpecks(not_seen);
  free_ = WithoutGaps(seen) & ~not_seen;
}

// Takes a pixel (column, row, 1) to where its ray meets the plane, in homogeneous cells.
Eigen::Matrix3f SupportGrid::CellsOfPixels(const CameraIntrinsics& intrinsics) const {
  Eigen::Matrix3d rays = Eigen::Matrix3d::Identity();
  rays(0, 0) = 1 / intrinsics.fx_px;
  rays(1, 1) = 1 / intrinsics.fy_px;
  rays(0, 2) = -intrinsics.cx_px / intrinsics.fx_px;
  rays(1, 2) = -intrinsics.cy_px / intrinsics.fy_px;
  // The share of the way to the plane that a ray makes on its first metre of depth.
  const Eigen::RowVector3f way = -surface_.normal.transpose() / surface_.offset_m;
  Eigen::Matrix3f cells;
  cells << axes_ - origin_ * way, cell_m_ * way;
  return cells * rays.cast<float>();
}

cv::Point2f SupportGrid::CellOf(const Eigen::Vector3f& point) const {
  const Eigen::Vector2f cell = (axes_ * point - origin_) / cell_m_;
  return {cell.x(), cell.y()};
}

Eigen::Vector3f SupportGrid::PointAt(const cv::Point2f& cell) const {
  const Eigen::Vector2f place = origin_ + cell_m_ * Eigen::Vector2f(cell.x, cell.y);
  return axes_.transpose() * place - surface_.offset_m * surface_.normal;
}

void SupportGrid::BlockPoint(const Eigen::Vector3f& point) {
  const cv::Point cell = CellOf(point);
  if (cv::Rect({0, 0}, free_.size()).contains(cell)) free_.at<uchar>(cell) = 0;
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
