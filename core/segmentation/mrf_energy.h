// The energy of the scene labelling (paper Eq. 1): data term from the object hypotheses, pairwise
// term from grooves, steps and colours in place of the paper's Eq. 7 (core/paper/surface_energy.h).
#pragma once

#include <vector>

#include "core/segmentation/clusters.h"
#include "core/segmentation/data_term.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/potts_energy.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct MrfOptions {
  // Seeds are dense, so that a hypothesis need not reach far, but may reach across an object.
  DataTermOptions data{.gamma_per_m2 = 30, .reach_m = 0.15};
  // The weight of the pairwise term is λ on flat and convex transitions and falls with the concave
  // angle a as exp(−a / concave_angle); degrees. Eq. 7 leaves flat surfaces, where the sign of Eq.
  // 8 is noise, to chance.
  double lambda = 6;
  double concave_angle_deg = 12;
  // How much of the angle of a step between surfaces that look the same way, one in front of the
  // other, is added to a.
  double step_weight = 0.6;
  // The share of the weight that is left between voxels of quite different colours. 1: only shape
  // counts.
  double color_floor = 0.35;
  // Neighbouring voxels are labelled together, up to this many at a time, where cutting between
  // them costs much; 1: every voxel by itself.
  int cluster_voxels = 16;
};

// What is labelled, and what its nodes are.
struct ClusteredEnergy {
  PottsEnergy energy;
  Clusters clusters;
};

// The energy over clusters of the voxels of `grid`, with the data term as in data_term.h. Voxels
// with `is_background` set (one entry a voxel) can only be background, and are in no cluster: what
// cutting between them and a cluster costs is taken off what it costs the cluster to be background.
// `colors`: one entry a voxel, as of ColorsOfVoxels. Throws TooComplex as DataTerm does.
ClusteredEnergy BuildEnergy(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                            const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                            const MrfOptions& options = {});

// The cost of cutting between two neighbouring voxels.
float PairwiseWeight(const Voxel& a, const Voxel& b, const MrfOptions& options);

// The share of it that the colours of the two voxels leave; 0 … 1.
float ColorShare(const MeanColor& a, const MeanColor& b, const MrfOptions& options);

}  // namespace fovea
