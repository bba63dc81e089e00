// A cup on a table, as voxels.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

inline const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();

// A cup of 5 cm radius and 8 cm height on a table, most of its wall seen from inside: labels 1 and
// 2 left and right of the middle. Its floor and the table around it are background; where the wall
// stands, no table is seen.
struct Cup {
  VoxelGrid grid;
  std::vector<int> labels;
  std::vector<char> on_wall;

  void Add(float x, float height, float z, const Eigen::Vector3f& normal, int label) {
    Voxel voxel;
    voxel.mean = {x, -height, z};
    voxel.normal = normal;
    voxel.num_points = 1;
    grid.voxels.push_back(voxel);
    labels.push_back(label);
  }
  // `facing`: 1 = normals inwards, -1 = outwards, of label 1; `gap_m`: how far it is moved aside.
  explicit Cup(float facing = 1, float gap_m = 0) : Cup(facing, facing, gap_m) {}
  Cup(float facing_of_1, float facing_of_2, float gap_m) {
    for (int degree = -25; degree < 210; degree += 10) {
      const float angle = static_cast<float>(degree) * std::numbers::pi_v<float> / 180;
      const Eigen::Vector3f out(std::cos(angle), 0, std::sin(angle));
      for (int cm = 1; cm < 8; ++cm) {
        const float height = 0.01F * static_cast<float>(cm) + 0.005F;
        const float shift = degree < 90 ? gap_m : 0;
        const float facing = degree < 90 ? facing_of_1 : facing_of_2;
        Add(0.05F * out.x() + shift, height, 1 + 0.05F * out.z(), -facing * out,
            degree < 90 ? 1 : 2);
      }
    }
    for (int i = -10; i < 10; ++i) {
      for (int j = -10; j < 10; ++j) {
        const float x = 0.01F * static_cast<float>(i);
        const float z = 1 + 0.01F * static_cast<float>(j);
        const float radius = std::hypot(x, z - 1);
        if (radius < 0.045F || radius > 0.06F) Add(x, 0.005F, z, kUp, 0);
      }
    }
    Connect();
  }
  void Connect() {
    grid.edges.clear();
    for (int a = 0; a < static_cast<int>(labels.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(labels.size()); ++b) {
        const float distance = (grid.voxels[a].mean - grid.voxels[b].mean).norm();
        if (distance < 0.0145F) grid.edges.push_back({a, b});
      }
    }
    on_wall.assign(labels.size(), 0);
  }
};

}  // namespace fovea
