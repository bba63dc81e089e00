// The search for objects of profile "default", from depth and colour to labelled voxels.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/options.h"
#include "core/refinement.h"
#include "core/scene_geometry.h"
#include "core/seeds/salient_positions.h"
#include "core/stage_clock.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"
#include "core/types/time_budget.h"

namespace fovea {

struct Salience {
  cv::Mat color, depth;  // CV_32FC1
};

// What has been found in the parts of a scene that were looked at, of which the last one is seen in
// a trace.
struct FoundObjects : RefinedScene {
  std::vector<int> labels;  // one entry a voxel, after the graph cut
  std::size_t num_segments = 0;
};

struct Search {
  cv::Mat depth;  // CV_32FC1 after hole filling, NaN = none
  SceneGeometry scene;
  Salience salience;
  SalientPositions salient;
  std::vector<Seed> seeds;  // that became object hypotheses
  cv::Mat saliency;         // of both maps
  FoundObjects found;
};

// Looks for objects in a frame of blocks of pixels (pixel_blocks.h). `camera`: of the pixels in
// which the region of interest is given. The first stage of `clock` has begun. Sets gravity,
// support, counts and whether `result` is incomplete, and lifts the budget.
Search SearchInBlocks(const RgbdFrame& frame, const CameraIntrinsics& camera,
                      const DetectorOptions& options, TimeBudget& budget, StageClock& clock,
                      Detections& result);

}  // namespace fovea
