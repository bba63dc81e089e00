// What of a support was seen to be empty, on a grid in its plane.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/level_axes.h"

namespace fovea {

class SupportGrid {
 public:
  // What rises above the support by more than `tolerance_m` and less than `height_m` stands in the
  // way. `points`: CV_32FC3, NaN = none.
  SupportGrid(const cv::Mat& points, const Support& support,
              const std::vector<DetectedObject>& objects, float height_m, float tolerance_m);

  const cv::Mat& free() const { return free_; }  // CV_8UC1, 255 where it is; at least 1x1
  float cell_m() const { return cell_m_; }
  const LevelAxes& axes() const { return axes_; }  // along the columns, and along the rows

  // The point of the support at a place in the grid, in cells; (0, 0) is the first cell's middle.
  Eigen::Vector3f PointAt(const cv::Point2f& cell) const;

 private:
  cv::Point2f CellOf(const Eigen::Vector3f& point) const;
  void BlockBox(const OrientedBox& box);

  SupportSurface surface_;
  LevelAxes axes_;
  Eigen::Vector2f origin_ = Eigen::Vector2f::Zero();
  float cell_m_ = 0.01F;
  cv::Mat free_;
};

}  // namespace fovea
