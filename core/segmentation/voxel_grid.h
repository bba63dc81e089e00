// The voxels of a scene and their neighbours: the nodes and edges of the Markov random field
// (paper section 3).
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/depth/normals.h"

namespace fovea {

struct VoxelOptions {
  double size_m = 0.01;  // edge length
  // True: voxels grow in proportion to the distance, as pixels do; size_m is their edge at 1 m.
  // Their cells are steps in x/z, y/z and ln z.
  bool perspective = false;
  // Along how many axes a neighbour may differ: 1 (6 neighbours, by faces), 2 (18, and by edges)
  // or 3 (26, and by corners).
  int neighbor_axes = 3;
  // How often each normal is replaced by the mean over itself and its neighbours.
  int normal_smoothing = 0;
};

struct Voxel {
  Eigen::Vector3i cell = Eigen::Vector3i::Zero();    // its place in the lattice
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();    // of its points, camera frame, metres
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, towards the camera; zero = none
  int num_points = 0;
  cv::Point first_px = {-1, -1};  // of its pixels, in row-major order
};

struct VoxelEdge {
  int a = 0;  // a < b, indices of voxels
  int b = 0;
};

struct VoxelGrid {
  std::vector<Voxel> voxels;     // in row-major order of their first pixel
  std::vector<VoxelEdge> edges;  // every pair of neighbours once
  cv::Mat voxel_of_pixel;        // CV_32SC1, frame size; -1 = no point
};

// Sorts the points into cubes. `points`: CV_32FC3, NaN = none.
VoxelGrid BuildVoxelGrid(const cv::Mat& points, const NormalMap& normals,
                         const VoxelOptions& options = {});

// The edges of which both ends have this value; `values`: one entry a voxel.
std::vector<VoxelEdge> EdgesWithin(const VoxelGrid& grid, const std::vector<char>& values,
                                   char value);

// Signed angle between the normals of two voxels in degrees: positive where the surface bulges
// from one to the other (convex), negative where it makes a groove; the sign of Eq. 8.
float ConvexityDeg(const Voxel& a, const Voxel& b);

// Signed angle in degrees between the way from a to b and the mean of the surfaces at both: 0 along
// one surface, also where it bends; positive where b lies in front of the surface at a, negative
// where it lies behind.
float StepDeg(const Voxel& a, const Voxel& b);

}  // namespace fovea
