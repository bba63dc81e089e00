// What of a support was seen to be empty, on a grid in its plane.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/relations/support_view.h"
#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/level_axes.h"

namespace fovea {

class SupportGrid {
 public:
  // What stands on the support and begins less than `height_m` above it is in the way. A cell is
  // free where most of the pixels that look there saw the support. What lies between the pixels is
  // as what is around it, and so are one or two cells of which most pixels saw nothing: cameras
  // miss single pixels everywhere. `objects`: that with label k at k - 1; `options`: by which the
  // support was found.
  SupportGrid(const ViewedScene& scene, const Support& support,
              const std::vector<DetectedObject>& objects, float height_m,
              const SupportOptions& options);

  const cv::Mat& free() const { return free_; }  // CV_8UC1, 255 where it is; at least 1x1
  float cell_m() const { return cell_m_; }
  const LevelAxes& axes() const { return axes_; }  // along the columns, and along the rows

  // The point of the support at a place in the grid, in cells; (0, 0) is the first cell's middle.
  Eigen::Vector3f PointAt(const cv::Point2f& cell) const;

 private:
  void FreeWhatIsSeen(const SupportView& view, const CameraIntrinsics& intrinsics);
  Eigen::Matrix3f CellsOfPixels(const CameraIntrinsics& intrinsics) const;
  cv::Point2f CellOf(const Eigen::Vector3f& point) const;
  void BlockPoint(const Eigen::Vector3f& point);
  void BlockBox(const OrientedBox& box);

  SupportSurface surface_;
  LevelAxes axes_;
  Eigen::Vector2f origin_ = Eigen::Vector2f::Zero();
  float cell_m_ = 0.01F;
  cv::Mat free_;
};

}  // namespace fovea
