// Which segments cannot be objects: walls, furniture, what hangs in the air. Goes beyond the paper,
// whose scenes show a table and nothing else.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct PlausibilityOptions {
  // Segments longer than this along an axis of their box are furniture or wall; metres.
  double max_size_m = 100;
  // Segments that lie under a support for the most part and reach up to less than this below it are
  // its edge or its legs, and what stands right below these is their lower end; metres, 0 switches
  // the test off.
  double max_hang_m = 0;
  // Segments taller than this along the vertical do not stand by themselves; metres. Counted from
  // their support where nothing is seen that they stand on: the seat of a chair, whose legs go with
  // it.
  double max_height_m = 100;
  // Segments at least 30 cm wide on another surface than the dominating one, with a side of more
  // than this share of the visible area of the part that they stand on, belong to it: the back of a
  // chair.
  double max_support_share = 100;
  // Segments whose lowest point is higher than this above their support must touch another one;
  // metres.
  double max_rest_m = 100;
  // Segments with fewer pixels that rise less than twice the support's tolerance above it are
  // noise; in images up to 640×480, in larger ones more by their area.
  double min_low_pixels = 0;
};

struct PlausibleSegments {
  std::vector<int> labels;  // as given, 0 where a segment was removed
  std::size_t num_removed = 0;
};

// `labels`: one entry a voxel, 0 = background, 1 … n without gaps; `points`: CV_32FC3 of the frame,
// NaN = none. Removed are segments that are too large by themselves or for their support, that are
// parts of furniture (core/objects/furniture.h), that are noise on their support, or that neither
// rest on one nor touch, directly or through others, one that does. Nothing is removed where there
// is no support.
PlausibleSegments RemoveImplausible(const VoxelGrid& grid, const std::vector<int>& labels,
                                    const cv::Mat& points, const CameraIntrinsics& intrinsics,
                                    const std::vector<Support>& supports,
                                    const SupportOptions& support_options,
                                    const PlausibilityOptions& options = {});

}  // namespace fovea
