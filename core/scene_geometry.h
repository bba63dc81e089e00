// What the depth image alone tells of the scene, before objects are looked for: which way is down,
// what carries things, the voxels, and which of them are no objects.
#pragma once

#include <vector>

#include "core/options.h"
#include "core/scene/gravity.h"
#include "core/scene/support_surface.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/stage_clock.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct SceneGeometry {
  Gravity gravity;
  std::vector<Support> supports;
  cv::Mat points;    // CV_32FC3 of all pixels, NaN = none; with what stands in for missing depth
  cv::Mat standing;  // CV_8UC1, not 0 where a surface stands in
  cv::Mat lab;       // CV_8UC3, as of LabOf
  VoxelGrid grid;
  // One entry a voxel.
  std::vector<MeanColor> colors;
  std::vector<char> is_background;
  std::vector<char> on_wall;
  std::vector<char> hidden;  // by the region of interest alone; empty without one
};

// `depth_m`: with small holes filled; `points`: its, as of BackProject, not changed; `camera`: in
// whose pixels the region of interest is given. The first stage of `clock`, "normals", has begun.
SceneGeometry FindGeometry(const RgbdFrame& frame, const cv::Mat& depth_m, const cv::Mat& points,
                           const CameraIntrinsics& camera, const DetectorOptions& options,
                           StageClock& clock);

}  // namespace fovea
