#include "core/segmentation/round_wall_merge.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kSameWall = 0.3;  // of the smaller radius, between centres, radii and rims

bool AreOneWall(const RoundWall& a, const RoundWall& b) {
  const double limit_m = kSameWall * std::min(a.radius_m, b.radius_m);
  return (a.is_inside || b.is_inside) && (a.center - b.center).norm() < limit_m &&
         std::abs(a.radius_m - b.radius_m) < limit_m && std::abs(a.rim_m - b.rim_m) < limit_m;
}

}  // namespace

std::vector<int> MergeRoundWalls(const std::vector<int>& labels, const RoundWalls& walls) {
  std::vector<int> round;  // labels of those that have one
  for (int label = 1; label < static_cast<int>(walls.size()); ++label) {
    if (walls[label]) round.push_back(label);
  }
  DisjointSets objects(static_cast<int>(walls.size()));
  for (auto a = round.begin(); a != round.end(); ++a) {
    InterruptionPoint();
    for (auto b = std::next(a); b != round.end(); ++b) {
      if (AreOneWall(*walls[*a], *walls[*b])) objects.Join(*a, *b);
    }
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
