#include "core/grasping/ranking.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Which a robot that fails with one need not try after it.
bool AreAlike(const Grasp& a, const Grasp& b) {
  constexpr float kFar_m = 0.015F;
  constexpr float kAligned = 0.95F;  // cosine: 18 degrees
  return (a.tool_center_point - b.tool_center_point).norm() < kFar_m &&
         std::abs(a.closing.dot(b.closing)) > kAligned && a.approach.dot(b.approach) > kAligned;
}

}  // namespace

std::vector<Grasp> RankGrasps(const std::vector<ScoredGrasp>& grasps, const Gripper& gripper) {
  std::vector<const Grasp*> likely;
  for (const ScoredGrasp& scored : grasps) {
    if (scored.grasp.probability >= gripper.min_probability) likely.push_back(&scored.grasp);
  }
  std::stable_sort(likely.begin(), likely.end(),
                   [](const Grasp* a, const Grasp* b) { return a->probability > b->probability; });
  std::vector<Grasp> ranked;
  for (const Grasp* grasp : likely) {
    if (ranked.size() >= static_cast<std::size_t>(gripper.max_grasps)) break;
    const bool is_known = std::any_of(ranked.begin(), ranked.end(),
                                      [&](const Grasp& other) { return AreAlike(*grasp, other); });
    if (!is_known) ranked.push_back(*grasp);
  }
  return ranked;
}

}  // namespace fovea
