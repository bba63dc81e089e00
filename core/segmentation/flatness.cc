#include "core/segmentation/flatness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/segmentation/labels.h"

namespace fovea {

void Spread::Add(const Spread& other) {
  num_voxels += other.num_voxels;
  sum += other.sum;
  outer_products += other.outer_products;
}

std::vector<Spread> SpreadOfSegments(const VoxelGrid& grid, const std::vector<int>& labels) {
  std::vector<Spread> spreads(CountLabels(labels) + 1);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    const Eigen::Vector3d mean = grid.voxels[v].mean.cast<double>();
    spreads[labels[v]].Add({1, mean, mean * mean.transpose()});
  }
  return spreads;
}

bool AreOnOnePlane(const Spread& a, const Spread& b, double noise_per_m) {
  constexpr double kExtentPerThickness = 3.5;
  Spread both = a;
  both.Add(b);
  const Eigen::Vector3d mean = both.sum / both.num_voxels;
  const Eigen::Matrix3d covariance =
      both.outer_products / both.num_voxels - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d deviation = solver.eigenvalues().cwiseMax(0).cwiseSqrt();  // ascending
  return deviation[0] < noise_per_m * mean.z() * mean.z() &&
         deviation[1] > kExtentPerThickness * deviation[0];
}

}  // namespace fovea
