#include "core/planning/height_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/depth/depth_gap.h"
#include "core/types/interruption.h"
#include "core/types/level_axes.h"

namespace fovea {
namespace {

// Along x, along y, above the grid.
using Place = Eigen::Vector3f;

// The cell whose middle is nearest, counted from the camera.
Eigen::Array2f CellOf(const Eigen::Vector2f& place) { return (place.array() + 0.5F).floor(); }

class Grid {
 public:
  Grid(const Eigen::Vector3f& up, float offset_m, float cell_m)
      : up_(up), offset_m_(offset_m), cell_m_(cell_m), axes_(LevelAxesAlongView(up)) {}

  Place PlaceOf(const cv::Vec3f& p) const {
    const Eigen::Vector3f point(p[0], p[1], p[2]);
    const Eigen::Vector2f level = axes_ * point / cell_m_;
    return {level.x(), level.y(), up_.dot(point) + offset_m_};
  }

  // From the first to the last cell that is seen, at most `max_cells` of them.
  void Enclose(const cv::Mat& points, int max_cells) {
    constexpr float kHuge = std::numeric_limits<float>::max();
    Eigen::Vector2f low = Eigen::Vector2f::Constant(kHuge), high = -low;
    for (int row = 0; row < points.rows; ++row) {
      InterruptionPoint();
      for (int column = 0; column < points.cols; ++column) {
        const auto& p = points.at<cv::Vec3f>(row, column);
        if (std::isnan(p[2])) continue;
        const Place place = PlaceOf(p);
        low = low.cwiseMin(place.head<2>());
        high = high.cwiseMax(place.head<2>());
      }
    }
    if (low.x() > high.x()) low = high = Eigen::Vector2f::Zero();
    const float most = static_cast<float>(max_cells);
    constexpr float kLongest = 1e9F;  // for an int
    const Eigen::Array2f first = CellOf(low);
    first_ = first.cast<int>();
    Eigen::Array2f extent = (CellOf(high) - first).min(kLongest) + 1;
    if (extent.prod() > most) Shorten(most, extent);
    heights_m_ = cv::Mat(static_cast<int>(extent.y()), static_cast<int>(extent.x()), CV_32FC1,
                         std::numeric_limits<float>::quiet_NaN());
  }

  void Raise(const Place& place) {
    const Eigen::Array2i own = CellOf(place.head<2>()).cast<int>() - first_;
    const cv::Point cell(own.x(), own.y());
    if (!cv::Rect({}, heights_m_.size()).contains(cell)) return;
    float& height = heights_m_.at<float>(cell);
    if (!(height >= place.z())) height = place.z();  // NaN is lower than all
  }

  // Everything from one place to the other.
  void RaiseBetween(const Place& from, const Place& to) {
    constexpr int kMostSteps = 64;
    const float length = (to - from).head<2>().cwiseAbs().maxCoeff();
    const int steps = std::min(kMostSteps, static_cast<int>(std::ceil(length)));
    for (int i = 1; i < steps; ++i) {
      Raise(from + (to - from) * (static_cast<float>(i) / static_cast<float>(steps)));
    }
  }

  HeightMap Map() const {
    HeightMap map;
    map.pose.linear() << axes_.transpose(), up_;
    map.pose.translation() =
        axes_.transpose() * (first_.cast<float>().matrix() * cell_m_) - offset_m_ * up_;
    map.cell_m = cell_m_;
    map.heights_m = heights_m_;
    return map;
  }

 private:
  // What is farther away goes first, then what is to the sides.
  void Shorten(float most, Eigen::Array2f& extent) {
    const float side = std::floor(std::sqrt(most));
    const float columns =
        std::min(extent.x(), std::max(side, std::floor(most / std::min(extent.y(), most))));
    const Eigen::Array2f kept(columns, std::min(extent.y(), std::floor(most / columns)));
    // Around the camera, where it looks down on both sides of itself.
    const Eigen::Array2i last = first_ + (extent - kept).cast<int>();
    first_ = (-kept / 2).cast<int>().max(first_).min(last);
    extent = kept;
  }

  Eigen::Vector3f up_;
  float offset_m_, cell_m_;
  LevelAxes axes_;
  Eigen::Array2i first_ = Eigen::Array2i::Zero();  // cell, counted from the camera
  cv::Mat heights_m_;
};

bool IsOneSurface(const cv::Vec3f& a, const cv::Vec3f& b) {
  return std::abs(a[2] - b[2]) <= DepthGap_m(std::min(a[2], b[2]));  // false for NaN
}

}  // namespace

HeightMap MakeHeightMap(const cv::Mat& points, const Eigen::Vector3f& up, float offset_m,
                        const PlanningOptions& options) {
  Grid grid(up, offset_m, options.cell_m);
  grid.Enclose(points, options.max_cells);
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    for (int column = 0; column < points.cols; ++column) {
      const auto& p = points.at<cv::Vec3f>(row, column);
      if (std::isnan(p[2])) continue;
      const Place place = grid.PlaceOf(p);
      grid.Raise(place);
      for (const cv::Point& next : {cv::Point(column + 1, row), cv::Point(column, row + 1)}) {
        if (next.x >= points.cols || next.y >= points.rows) continue;
        const auto& q = points.at<cv::Vec3f>(next);
        if (IsOneSurface(p, q)) grid.RaiseBetween(place, grid.PlaceOf(q));
      }
    }
  }
  return grid.Map();
}

}  // namespace fovea
