// The energy of the scene labelling as the paper has it (Eq. 1, 2, 5 to 8).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/data_term.h"
#include "core/segmentation/potts_energy.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea::paper {

struct SurfaceEnergyOptions {
  DataTermOptions data{};
  // Eq. 7, both unstated in the paper: weight of the pairwise term, and the share of it that is
  // left at transitions that are not convex.
  double lambda = 7;
  double epsilon = 0.04;
  double normal_constant = 0.1;  // Eq. 7: the "small constant" added to the normals' distance
  int max_sweeps = 5;            // of alpha-expansion
};

// Data term as in data_term.h, Eq. 7 between neighbouring voxels. Arguments as of DataTerm.
PottsEnergy BuildSurfaceEnergy(const VoxelGrid& grid, const cv::Mat& points,
                               const std::vector<char>& is_background, const cv::Mat& on_support,
                               const std::vector<Seed>& seeds,
                               const SurfaceEnergyOptions& options = {});

// Eq. 7 without the indicator: the cost of cutting between two neighbouring voxels.
float SurfaceWeight(const Voxel& a, const Voxel& b, const SurfaceEnergyOptions& options);

}  // namespace fovea::paper
