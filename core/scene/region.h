// The part of a frame in which objects are looked for.
#pragma once

#include <Eigen/Core>

#include "core/types/rgbd_frame.h"

namespace fovea {

struct RegionOptions {
  // The region of interest, a rectangle of the image; pixels. A width or height of 0 reaches to the
  // end of the image.
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
  // The workspace, a box along the axes of the camera frame; metres.
  double min_x_m = -100;
  double max_x_m = 100;
  double min_y_m = -100;
  double max_y_m = 100;
  double min_z_m = 0;
  double max_z_m = 100;

  bool operator==(const RegionOptions&) const = default;
};

// Throws std::invalid_argument, which names the option, if no point of a frame of this size can lie
// in the region: a rectangle beyond the image, or a workspace whose end comes before its start.
void RequireNotEmpty(const RegionOptions& options, const cv::Size& size);

// True if the point, in the camera frame, lies in the workspace and shows in the region of
// interest; of every point where the options are the default ones. Gravity and supports are found
// in the whole frame all the same.
bool IsInRegion(const Eigen::Vector3f& point, const CameraIntrinsics& intrinsics,
                const RegionOptions& options);

}  // namespace fovea
