#include "core/grasping/ranking.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

std::vector<Grasp> RankGrasps(const std::vector<ScoredGrasp>& grasps, const Gripper& gripper,
                              const std::function<float(Grasp&)>& doubt) {
  const auto is_likely = [&](const Grasp& grasp) {
    return grasp.probability >= gripper.min_probability;
  };
  std::vector<const Grasp*> likely;
  for (const ScoredGrasp& scored : grasps) {
    if (is_likely(scored.grasp)) likely.push_back(&scored.grasp);
  }
  std::stable_sort(likely.begin(), likely.end(),
                   [](const Grasp* a, const Grasp* b) { return a->probability > b->probability; });
  const auto wanted = static_cast<std::size_t>(gripper.max_grasps);
  std::vector<Grasp> ranked, doubted;
  for (const Grasp* grasp : likely) {
    if (ranked.size() >= wanted) break;
    const auto is_alike = [&](const Grasp& other) { return AreAlike(*grasp, other); };
    if (std::any_of(ranked.begin(), ranked.end(), is_alike)) continue;
    if (std::any_of(doubted.begin(), doubted.end(), is_alike)) continue;
    Grasp looked_at = *grasp;
    const float left = doubt(looked_at);
    looked_at.probability *= left;
    (left < 1 ? doubted : ranked).push_back(looked_at);
  }
  if (doubted.empty()) return ranked;
  std::copy_if(doubted.begin(), doubted.end(), std::back_inserter(ranked), is_likely);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Grasp& a, const Grasp& b) { return a.probability > b.probability; });
  if (ranked.size() > wanted) ranked.resize(wanted);
  return ranked;
}

}  // namespace fovea
