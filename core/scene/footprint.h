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

  // True if the point's projection along the normal lies inside.
  bool Covers(const Eigen::Vector3f& point) const { return PartAt(point) >= 0; }

  // Which of the parts covers the point, one of them where hulls overlap; -1: none. An unbounded
  // footprint is one part.
  int PartAt(const Eigen::Vector3f& point) const;

  // Of each part that was not left out, as seen, without what is hidden; empty if unbounded.
  const std::vector<double>& PartAreasM2() const { return part_areas_m2_; }

  // The sum of these; 0 if unbounded.
  double AreaM2() const;

 private:
  std::vector<cv::Point> CellsOf(const std::vector<Eigen::Vector3f>& points) const;

  LevelAxes axes_;
  Eigen::Vector2f origin_;  // of the grid, in plane coordinates
  float cell_m_ = 0;        // edge length of its cells
  cv::Mat part_of_cell_;    // CV_16UC1, part + 1, 0 = none; empty = unbounded
  std::vector<double> part_areas_m2_;
};

}  // namespace fovea
