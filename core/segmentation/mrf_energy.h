// The energy of the scene labelling (paper Eq. 1): data term from the object hypotheses (Eq. 2, 5,
// 6), pairwise term from the surface shape (Eq. 7, 8).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/potts_energy.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct MrfOptions {
  double gamma_per_m2 = 180;  // Eq. 5: how fast a hypothesis fades with distance; 1/m². Paper: 180
  double alpha = 0.1;         // Eq. 6: weight of the background. Paper: 0.1
  double lambda = 4;          // Eq. 7: weight of the pairwise term
  double epsilon = 0.1;       // Eq. 7: share of the weight left at concave transitions
  double normal_constant = 0.1;  // Eq. 7: the "small constant" added to the normals' distance
  // 0: weights by Eq. 7. Otherwise the weight is λ on flat and convex transitions and falls with
  // the concave angle a as exp(−a / concave_angle); degrees. Eq. 7 leaves flat surfaces, where the
  // sign of Eq. 8 is noise, to chance.
  double concave_angle_deg = 0;
  // With concave_angle: how much of the angle of a step between surfaces that look the same way,
  // one in front of the other, is added to a.
  double step_weight = 0;
  // The weight between voxels whose colours are farther apart than color_distance falls towards
  // color_floor of itself, by a factor of e every color_scale; units of mean_color.h. Floor 1: only
  // shape counts.
  double color_floor = 1;
  double color_distance = 12;
  double color_scale = 8;
  // Probabilities below this count as this, since Eq. 6 is 0 at a seed; a hypothesis is no choice
  // for voxels where Eq. 5 is below it.
  double min_probability = 1e-6;
  // Nor for voxels whose mean is farther than this from the seed; metres.
  double reach_m = 100;
  int max_sweeps = 5;  // of alpha-expansion
  // Sweeps after the first are only over labels that some voxel has.
  bool only_owners = false;
  // In the first sweep neighbouring voxels are labelled together, up to this many at a time, where
  // cutting between them would cost at least cluster_min_share of λ; 1: every voxel by itself.
  int cluster_voxels = 1;
  double cluster_min_share = 0.8;
};

// The energy over the voxels of `grid`: label 0 is the background, label k the hypothesis of
// seeds[k - 1]. Voxels with `is_background` set (one entry a voxel) can only be background: the
// support surface, where the paper sets the background's probability to one. A hypothesis offers
// itself to the voxels within `reach_m` where Eq. 5 is above `min_probability`.
// `points`: CV_32FC3, the image that the grid was built from. Throws TooComplex if there
// are more choices of voxel and hypothesis than memory should hold (2^25). `colors`: one entry a
// voxel, as of ColorsOfVoxels; not used where color_floor is 1.
PottsEnergy BuildEnergy(const VoxelGrid& grid, const cv::Mat& points,
                        const std::vector<MeanColor>& colors,
                        const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                        const MrfOptions& options = {});

// Eq. 7 without the indicator: the cost of cutting between two neighbouring voxels.
float PairwiseWeight(const Voxel& a, const Voxel& b, const MrfOptions& options);

// The share of it that the colours of the two voxels leave; 0 … 1.
float ColorShare(const MeanColor& a, const MeanColor& b, const MrfOptions& options);

}  // namespace fovea
