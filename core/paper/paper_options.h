// What profile "paper" lets one choose: the paper's values, and the readings that it leaves open
// (docs/pipeline.md has what each of them gives).
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "core/depth/fill_depth_holes.h"
#include "core/depth/normals.h"
#include "core/objects/describe_objects.h"
#include "core/paper/color_merge.h"
#include "core/paper/surface_energy.h"
#include "core/saliency/depth_saliency.h"
#include "core/saliency/strength_saliency.h"
#include "core/scene/gravity.h"
#include "core/scene/region.h"
#include "core/scene/support_surface.h"
#include "core/seeds/saliency_seeds.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea::paper {

// Section 3.2 says of the points on the dominating support surface that the background has "a
// probability value of one" there.
struct SupportReading {
  // False: −ln 1 is what the background costs them, and Eq. 5 stays for the hypotheses. True: their
  // voxels, and all below, can be nothing else.
  bool hard = false;
  // The same for points below the surface.
  bool includes_below = true;
  // Seeds below the surface are removed as those on it are.
  bool removes_seeds_below = true;
};

// In the order of the pipeline.
struct PaperOptions {
  double max_depth_m = 10;  // points farther away are left out
  RegionOptions region;
  DepthFillOptions depth_fill;
  NormalOptions normals;
  StrengthSaliencyOptions color_saliency;
  DepthSaliencyOptions depth_saliency{.center_prior = true};
  // Superpixels on which the depth saliency is constant, as a multiple of the image diagonal in
  // pixels (Ju: 1); 0 evaluates every pixel on its own.
  double superpixels_per_diagonal = 0;
  SeedOptions seeds{.disk_radius_px = 10, .on_peak = false};
  GravityOptions gravity;
  SupportOptions support{.plane_fits = 0};  // exactly perpendicular to gravity
  SupportReading support_reading;
  VoxelOptions voxels{.size_m = 0.015};
  SurfaceEnergyOptions mrf;
  ColorMergeOptions color_merge;
  ObjectOptions objects;

  // Pixels of the frame to take as seed positions instead of those that the saliency maps give, as
  // from an eye tracker or to see what better seeds would give; empty: those of the maps.
  std::vector<cv::Point> fixations;
};

}  // namespace fovea::paper
