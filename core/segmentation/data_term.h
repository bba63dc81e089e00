// The data term of the scene labelling: what the object hypotheses and the background say of each
// voxel (paper Eq. 2, 5 and 6).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/potts_energy.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct DataTermOptions {
  double gamma_per_m2 = 180;  // Eq. 5: how fast a hypothesis fades with distance; 1/m². Paper: 180
  double alpha = 0.1;         // Eq. 6: weight of the background. Paper: 0.1
  // Probabilities below this count as this, since Eq. 6 is 0 at a seed; a hypothesis is no choice
  // for voxels where Eq. 5 is below it.
  double min_probability = 1e-6;
  // Nor for voxels whose mean is farther than this from the seed; metres.
  double reach_m = 100;
};

// Eq. 6 where the nearest seed is this far: -ln(alpha (1 - p)), with p of Eq. 5; square metres.
float BackgroundCost(float squared_distance, const DataTermOptions& options);

// The choices of a PottsEnergy over the voxels of `grid` and what each costs: label 0 is the
// background, label k the hypothesis of seeds[k - 1], −ln p on average over the voxel's points; for
// the background (Eq. 6) as if all of them were as far from the nearest seed as they are on average
// (point by point: core/paper/background_costs.h).
//
// Voxels with `is_background` set (one entry a voxel) can only be background. `points`: CV_32FC3,
// the image that the grid was built from. Throws TooComplex if there are more choices of voxel and
// hypothesis than memory should hold (2^25).
std::vector<std::vector<PottsEnergy::Choice>> DataTerm(const VoxelGrid& grid, const cv::Mat& points,
                                                       const std::vector<char>& is_background,
                                                       const std::vector<Seed>& seeds,
                                                       const DataTermOptions& options = {});

}  // namespace fovea
