#include "core/scene/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"
#include "core/types/squares.h"

namespace fovea {
namespace {

constexpr float kCellM = 0.03F;    // at least
constexpr float kMaxCells = 2048;  // along a side, however far the points reach

// Of the points, along both axes; one at least.
struct Bounds {
  Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector2f high = -low;
  Eigen::Vector2f Size() const { return high - low; }
};

Bounds BoundsOf(const std::vector<Eigen::Vector3f>& points, const LevelAxes& axes) {
  Bounds bounds;
  for (const Eigen::Vector3f& point : points) {
    bounds.low = bounds.low.cwiseMin(axes * point);
    bounds.high = bounds.high.cwiseMax(axes * point);
  }
  return bounds;
}

float CellFor(const Bounds& bounds) {
  return std::max(kCellM, bounds.Size().maxCoeff() / kMaxCells);
}

// Cells with points, closed over gaps of one cell (far surfaces are sampled thinly).
cv::Mat Occupancy(const std::vector<cv::Point>& cells, const cv::Size& size) {
  InterruptionPoint();
  cv::Mat occupied = cv::Mat::zeros(size, CV_8UC1);
  const cv::Rect grid({0, 0}, size);
  for (const cv::Point& cell : cells) {
    if (grid.contains(cell)) occupied.at<uchar>(cell) = 255;
  }
  CloseGaps(1, occupied);
  return occupied;
}

// Draws the hull of the cells that are set.
void FillHull(const cv::Mat& set, cv::Mat hulls) {
  std::vector<cv::Point> cells;
  cv::findNonZero(set, cells);
  std::vector<cv::Point> hull;
  cv::convexHull(cells, hull);
  cv::fillConvexPoly(hulls, hull, cv::Scalar(255));
}

}  // namespace

Footprint::Footprint(const std::vector<Eigen::Vector3f>& points,
                     const std::vector<Eigen::Vector3f>& above, const SupportSurface& surface,
                     double min_area_m2, double margin_m)
    : axes_(LevelAxesFor(surface.normal)) {
  const Bounds bounds = BoundsOf(points, axes_);
  cell_m_ = CellFor(bounds);
  const int border = static_cast<int>(std::ceil(margin_m / cell_m_)) + 2;
  origin_ = bounds.low - Eigen::Vector2f::Constant(cell_m_ * static_cast<float>(border));
  const Eigen::Vector2i extent = (bounds.Size() / cell_m_).cast<int>().array() + 2 * border + 1;
  const cv::Size size(extent.x(), extent.y());
  InterruptionPoint();

  std::vector<cv::Point> cells = CellsOf(points);
  const cv::Mat occupied = Occupancy(cells, size);
  const std::vector<cv::Point> covered = CellsOf(above);
  cells.insert(cells.end(), covered.begin(), covered.end());
  is_covered_ = cv::Mat::zeros(size, CV_8UC1);
  InterruptionPoint();
  cv::Mat parts, statistics, centroids;
  const int num_parts =
      cv::connectedComponentsWithStats(Occupancy(cells, size), parts, statistics, centroids);
  for (int part = 1; part < num_parts; ++part) {
    const int* of_part = statistics.ptr<int>(part);
    InterruptionPoint();
    const cv::Rect box(of_part[cv::CC_STAT_LEFT], of_part[cv::CC_STAT_TOP],
                       of_part[cv::CC_STAT_WIDTH], of_part[cv::CC_STAT_HEIGHT]);
    const cv::Mat seen = (parts(box) == part) & occupied(box);
    const double area = cv::countNonZero(seen) * cell_m_ * cell_m_;
    if (area == 0 || area < min_area_m2) continue;
    area_m2_ += area;
    FillHull(seen, is_covered_(box));
  }
  const int reach = 2 * static_cast<int>(std::lround(margin_m / cell_m_)) + 1;
  InterruptionPoint();
  cv::dilate(is_covered_, is_covered_,
             cv::getStructuringElement(cv::MORPH_ELLIPSE, {reach, reach}));
}

double Footprint::LargestAreaM2(const std::vector<Eigen::Vector3f>& points,
                                const SupportSurface& surface) {
  InterruptionPoint();
  const Bounds bounds = BoundsOf(points, LevelAxesFor(surface.normal));
  // The outermost points may lie anywhere in their cells.
  return (bounds.Size().array() + 2 * CellFor(bounds)).prod();
}

std::vector<cv::Point> Footprint::CellsOf(const std::vector<Eigen::Vector3f>& points) const {
  InterruptionPoint();
  std::vector<cv::Point> cells;
  cells.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector2f cell = (axes_ * point - origin_) / cell_m_;
    cells.emplace_back(cvFloor(cell.x()), cvFloor(cell.y()));
  }
  return cells;
}

bool Footprint::Covers(const Eigen::Vector3f& point) const {
  if (is_covered_.empty()) return true;
  const Eigen::Vector2f cell = (axes_ * point - origin_) / cell_m_;
  // Lines of sight along the surface meet it too far away for an int, or nowhere.
  const auto is_within = [](float place, int size) {
    return place >= 0 && place < static_cast<float>(size);
  };
  if (!is_within(cell.x(), is_covered_.cols) || !is_within(cell.y(), is_covered_.rows)) {
    return false;
  }
  return is_covered_.at<uchar>(static_cast<int>(cell.y()), static_cast<int>(cell.x())) != 0;
}

}  // namespace fovea
