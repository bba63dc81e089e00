// From labelled voxels to objects (paper section 3.3, and the rules beyond it).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/options.h"

namespace fovea {

// What is known of a scene by then.
struct LabelledScene {
  const VoxelGrid& grid;
  const std::vector<int>& labels;        // one entry a voxel, 0 = background
  const cv::Mat& points;                 // CV_32FC3 in the camera frame, NaN = none
  const std::vector<MeanColor>& colors;  // one entry a voxel
  const CameraIntrinsics& intrinsics;
  Eigen::Vector3f up;  // unit vector
  const std::vector<Support>& supports;
  const std::vector<char>& on_wall;  // one entry a voxel, not 0 on walls of the room
};

struct RefinedScene {
  std::vector<int> segments;  // one entry a voxel, before parts are joined; 0 = background
  std::vector<int> merged;    // likewise, after
  std::vector<int> objects;   // likewise, what was joined and may be an object: 1 … n
  std::size_t num_segments = 0;
  std::size_t num_merged = 0;       // segments that were joined to another
  std::size_t num_implausible = 0;  // and then removed
};

// Splits the labels into connected segments, joins those that are one object and removes what can
// be none. Throws TooComplex for more than 65535 segments.
RefinedScene Refine(const LabelledScene& scene, const DetectorOptions& options);

}  // namespace fovea
