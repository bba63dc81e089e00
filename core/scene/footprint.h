// Where on a surface things may stand.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/detections.h"
#include "core/types/level_axes.h"

namespace fovea {

// The convex hulls of the connected parts of a surface, drawn on a grid in its plane. Convex, since
// what stands on a surface hides the part behind it.
class Footprint {
 public:
  // Unbounded: covers every point.
  Footprint() = default;

  // From the points that lie on the surface; parts smaller than `min_area_m2` are left out, the
  // hulls grow by `margin_m`. Parts are also connected where the points `above` stand between them:
  // a pile of objects parts what is seen of a table.
  Footprint(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& above,
            const SupportSurface& surface, double min_area_m2, double margin_m);

  // As much as AreaM2 can be at most, for a look before all that work.
  static double LargestAreaM2(const std::vector<Eigen::Vector3f>& points,
                              const SupportSurface& surface);

  // True if the point's projection along the normal lies inside.
  bool Covers(const Eigen::Vector3f& point) const;

  // Of the parts that were not left out, as seen, without what is hidden; 0 if unbounded.
  double AreaM2() const { return area_m2_; }

 private:
  std::vector<cv::Point> CellsOf(const std::vector<Eigen::Vector3f>& points) const;

  LevelAxes axes_;
  Eigen::Vector2f origin_;  // of the grid, in plane coordinates
  float cell_m_ = 0;        // edge length of its cells
  cv::Mat is_covered_;      // CV_8UC1, 255 where a hull is; empty = unbounded
  double area_m2_ = 0;
};

}  // namespace fovea
