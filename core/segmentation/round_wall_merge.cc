#include "core/segmentation/round_wall_merge.h"

#include <algorithm>
#include <cmath>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/round_wall.h"

namespace fovea {
namespace {

constexpr double kSameWall = 0.3;  // of the smaller radius, between centres, radii and rims

bool AreOneWall(const RoundWall& a, const RoundWall& b) {
  const double limit_m = kSameWall * std::min(a.radius_m, b.radius_m);
  return (a.is_inside || b.is_inside) && (a.center - b.center).norm() < limit_m &&
         std::abs(a.radius_m - b.radius_m) < limit_m && std::abs(a.rim_m - b.rim_m) < limit_m;
}

}  // namespace

std::vector<int> MergeRoundWalls(const VoxelGrid& grid, const std::vector<int>& labels,
                                 const Eigen::Vector3f& up, double max_radius_m) {
  if (max_radius_m <= 0) return labels;
  const auto walls = FindRoundWalls(grid, labels, up, max_radius_m);
  const int num_labels = static_cast<int>(walls.size());
  DisjointSets objects(num_labels);
  for (int a = 1; a < num_labels; ++a) {
    for (int b = a + 1; b < num_labels; ++b) {
      if (walls[a] && walls[b] && AreOneWall(*walls[a], *walls[b])) objects.Join(a, b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
