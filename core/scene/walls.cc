#include "core/scene/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/scene/plane_fit.h"
#include "core/scene/plane_votes.h"
#include "core/types/interruption.h"
#include "core/types/squares.h"

namespace fovea {
namespace {

constexpr int kMaxPlanes = 8;
constexpr double kMinAreaM2 = 0.08;    // visible, of a part that is wall
constexpr float kWallCellM = 0.04F;    // of the grid on a plane, at least
constexpr float kMaxWallCells = 2048;  // along a side of it, however far the points reach
constexpr int kSolidReach = 2;         // of a square within a wall: legs of a table have none
constexpr float kMinWallCosine =
    std::numbers::sqrt2_v<float> / 2;  // of what has a plane's direction

// Voxels on no support whose normal lies within 45° of the horizon: noise tilts normals far away.
std::vector<int> UprightVoxels(const VoxelGrid& grid, const Eigen::Vector3f& up,
                               const std::vector<Support>& supports,
                               const SupportOptions& tolerance) {
  const float max_sine = std::numbers::sqrt2_v<float> / 2;
  LongLoop loop;
  std::vector<int> upright;
  upright.reserve(grid.voxels.size());
  for (int v = 0; v < static_cast<int>(grid.voxels.size()); ++v) {
    loop.Turn();
    const Eigen::Vector3f& normal = grid.voxels[v].normal;
    if (normal.isZero() || std::abs(normal.dot(up)) >= max_sine) continue;
    if (!IsOnSupport(supports, grid.voxels[v].mean, tolerance)) upright.push_back(v);
  }
  return upright;
}

bool IsNear(const Eigen::Vector3f& p, const SupportSurface& plane, const SupportOptions& tolerance,
            float widening) {
  return std::abs(plane.HeightOf(p)) <= widening * SupportTolerance(p.z(), tolerance);
}

std::vector<int> Inliers(const VoxelGrid& grid, const std::vector<int>& voxels,
                         const SupportSurface& plane, const SupportOptions& tolerance) {
  std::vector<int> inliers;
  inliers.reserve(voxels.size());
  InterruptionPoint();
  std::copy_if(voxels.begin(), voxels.end(), std::back_inserter(inliers),
               [&](int v) { return IsNear(grid.voxels[v].mean, plane, tolerance, 1); });
  return inliers;
}

// Those of the inliers that face where the plane does.
std::vector<int> Facing(const VoxelGrid& grid, std::vector<int> inliers,
                        const SupportSurface& plane) {
  std::erase_if(inliers,
                [&](int v) { return grid.voxels[v].normal.dot(plane.normal) < kMinWallCosine; });
  return inliers;
}

SupportSurface Refine(const VoxelGrid& grid, const std::vector<int>& candidates,
                      SupportSurface plane, const SupportOptions& tolerance) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(candidates.size());
  for (const float widening : {2.0F, 1.5F, 1.0F}) {
    InterruptionPoint();
    points.clear();
    for (const int v : candidates) {
      const Eigen::Vector3f& p = grid.voxels[v].mean;
      if (IsNear(p, plane, tolerance, widening)) points.push_back(p);
    }
    if (points.size() < 3) break;
    plane = FitPlane(points, plane.normal);
  }
  return plane;
}

// Whether each of the voxels belongs to a large connected part of the plane.
class LargeParts {
 public:
  LargeParts(const VoxelGrid& grid, const std::vector<int>& voxels, const SupportSurface& plane,
             const Eigen::Vector3f& up, const WallOptions& options)
      : vertical_((up - up.dot(plane.normal) * plane.normal).normalized()),
        horizontal_(vertical_.cross(plane.normal)),
        origin_(Eigen::Vector2f::Zero()) {
    if (voxels.empty()) return;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::max());
    Eigen::Vector2f high = -low;
    for (const int v : voxels) {
      low = low.cwiseMin(OnPlane(grid.voxels[v].mean));
      high = high.cwiseMax(OnPlane(grid.voxels[v].mean));
    }
    const float extent_m = (high - low).maxCoeff();
    cell_m_ = std::max(kWallCellM, extent_m / kMaxWallCells);
    if (extent_m + 2 * cell_m_ < options.min_extent_m) return;  // as most planes of small things
    origin_ = low - Eigen::Vector2f::Constant(2 * cell_m_);
    const Eigen::Vector2i size = ((high - low) / cell_m_).cast<int>().array() + 5;
    cv::Mat occupied = cv::Mat::zeros(size.y(), size.x(), CV_8UC1);
    for (const int v : voxels) occupied.at<uchar>(CellOf(grid.voxels[v].mean)) = 255;
    // Far surfaces are sampled thinly and have holes.
    CloseGaps(1, occupied);
    Keep(occupied, options);
  }

  bool Exist() const { return exist_; }
  bool Contain(const Eigen::Vector3f& point) const {
    const cv::Point cell = CellOf(point);
    return cv::Rect({}, large_.size()).contains(cell) && large_.at<uchar>(cell) != 0;
  }

 private:
  Eigen::Vector2f OnPlane(const Eigen::Vector3f& p) const {
    return {horizontal_.dot(p), vertical_.dot(p)};
  }
  cv::Point CellOf(const Eigen::Vector3f& point) const {
    const Eigen::Vector2f cell = (OnPlane(point) - origin_) / cell_m_;
    return {cvFloor(cell.x()), cvFloor(cell.y())};
  }

  void Keep(const cv::Mat& occupied, const WallOptions& options) {
    large_ = cv::Mat::zeros(occupied.size(), CV_8UC1);
    cv::Mat parts, statistics, centroids;
    cv::Mat solid = occupied.clone();
    TakeLeastAround(kSolidReach, solid);
    const int count = cv::connectedComponentsWithStats(occupied, parts, statistics, centroids);
    for (int part = 1; part < count; ++part) {
      const int* stats = statistics.ptr<int>(part);
      InterruptionPoint();
      const int extent = std::max(stats[cv::CC_STAT_WIDTH], stats[cv::CC_STAT_HEIGHT]);
      const float area_m2 = static_cast<float>(stats[cv::CC_STAT_AREA]) * cell_m_ * cell_m_;
      if (static_cast<float>(extent) * cell_m_ < options.min_extent_m) continue;
      if (area_m2 < kMinAreaM2) continue;
      const cv::Mat is_part = parts == part;
      if (cv::countNonZero(solid & is_part) == 0) continue;
      large_.setTo(255, is_part);
      exist_ = true;
    }
    TakeLargestAround(1, large_);
  }

  Eigen::Vector3f vertical_, horizontal_;  // the plane's axes
  Eigen::Vector2f origin_;                 // of the grid
  float cell_m_ = kWallCellM;              // edge length of its cells
  cv::Mat large_;                          // CV_8UC1, one pixel a cell
  bool exist_ = false;
};

}  // namespace

std::vector<char> FindWalls(const VoxelGrid& grid, const Eigen::Vector3f& up,
                            const std::vector<Support>& supports, const SupportOptions& tolerance,
                            const WallOptions& options) {
  std::vector<char> on_wall(grid.voxels.size(), 0);
  if (options.min_extent_m <= 0) return on_wall;
  const std::vector<int> upright = UprightVoxels(grid, up, supports, tolerance);
  std::vector<int> candidates = upright;
  PlaneVotes votes(grid, upright, up);
  for (int i = 0; i < kMaxPlanes && candidates.size() >= 3; ++i) {
    const std::optional<SupportSurface> voted = votes.MostVoted();
    if (!voted) break;
    const SupportSurface plane = Refine(grid, candidates, *voted, tolerance);
    const auto is_on_plane = [&](int v) {
      return IsNear(grid.voxels[v].mean, plane, tolerance, 1);
    };
    if (std::none_of(candidates.begin(), candidates.end(), is_on_plane)) break;
    // Also of those that went to an earlier plane, perhaps one across this wall.
    const std::vector<int> inliers = Facing(grid, Inliers(grid, upright, plane, tolerance), plane);
    const LargeParts parts(grid, inliers, plane, up, options);
    InterruptionPoint();
    if (parts.Exist()) {
      for (std::size_t v = 0; v < on_wall.size(); ++v) {
        const Eigen::Vector3f& p = grid.voxels[v].mean;
        if (IsNear(p, plane, tolerance, 1.5F) && parts.Contain(p)) on_wall[v] = 1;
      }
    }
    const auto explained = std::stable_partition(candidates.begin(), candidates.end(), [&](int v) {
      return !IsNear(grid.voxels[v].mean, plane, tolerance, 1.5F);
    });
    votes.Remove({explained, candidates.end()});
    candidates.erase(explained, candidates.end());
  }
  return on_wall;
}

}  // namespace fovea
