#include "core/grasping/plan_grasps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/grasping/grasp_model.h"
#include "core/grasping/hand_grid.h"
#include "core/grasping/jaw_grasps.h"
#include "core/grasping/ranking.h"
#include "core/grasping/suction_grasps.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Around the object, what the widest hand needs.
float ReachOf(const Gripper& gripper) {
  constexpr float kRoom_m = 0.03F;
  const auto* jaw = std::get_if<JawGripper>(&gripper.hand);
  if (jaw == nullptr) return std::get<SuctionGripper>(gripper.hand).diameter_m + kRoom_m;
  return jaw->max_opening_m / 2 + jaw->finger_thickness_m + kRoom_m;
}

// The ways in that are tried: the preferred one, and level ones where the gripper may tilt that
// far.
std::vector<Eigen::Vector3f> ApproachesOf(const Gripper& gripper, const Eigen::Vector3f& up,
                                          const DetectedObject& object) {
  constexpr float kLevel_rad = 1.4F;
  const Eigen::Vector3f preferred = gripper.approach.value_or(-up);
  std::vector<Eigen::Vector3f> approaches = {preferred};
  if (gripper.max_tilt_rad < kLevel_rad || std::abs(preferred.dot(up)) < 0.5F) return approaches;
  const Eigen::Vector3f away = object.box.center - up * up.dot(object.box.center);
  if (away.norm() > 0.01F) approaches.push_back(away.normalized());
  return approaches;
}

class Planner {
 public:
  Planner(const GraspScene& scene, const std::vector<Gripper>& grippers,
          const std::vector<DetectedObject>& objects)
      : scene_(scene), grippers_(grippers), objects_(objects) {
    for (const Gripper& gripper : grippers) reach_m_ = std::max(reach_m_, ReachOf(gripper));
  }

  // What was found for each gripper, and what failed.
  struct Found {
    std::vector<ScoredGrasp> grasps;
    Failures failures;
  };

  std::vector<Found> PlanFor(std::size_t target) const {
    std::vector<Found> found(grippers_.size());
    std::vector<std::pair<Eigen::Vector3f, HandGrid>> grids;  // by approach
    for (std::size_t g = 0; g < grippers_.size(); ++g) {
      for (const Eigen::Vector3f& approach :
           ApproachesOf(grippers_[g], scene_.up, objects_[target])) {
        InterruptionPoint();
        auto known = std::find_if(grids.begin(), grids.end(),
                                  [&](const auto& entry) { return entry.first == approach; });
        if (known == grids.end()) {
          grids.emplace_back(approach, BuildHandGrid(scene_, objects_, target, approach, reach_m_));
          known = std::prev(grids.end());
        }
        Find(target, g, known->second, found[g]);
      }
    }
    const GraspModel& model = FittedGraspModel();
    for (Found& own : found) {
      for (ScoredGrasp& scored : own.grasps) scored.grasp.probability = model.Probability(scored);
    }
    return found;
  }

 private:
  void Find(std::size_t target, std::size_t g, const HandGrid& grid, Found& found) const {
    const DetectedObject& object = objects_[target];
    std::vector<ScoredGrasp> grasps;
    if (const auto* jaw = std::get_if<JawGripper>(&grippers_[g].hand)) {
      std::vector<JawHand> hands = {{g, *jaw, found.failures, {}}};
      FindJawGrasps(scene_, object, grid, hands);
      grasps = std::move(hands[0].grasps);
      found.failures = hands[0].failures;
    } else {
      grasps = FindSuctionGrasps(scene_, object, grid, grippers_[g], g, found.failures);
    }
    std::move(grasps.begin(), grasps.end(), std::back_inserter(found.grasps));
  }

  const GraspScene& scene_;
  const std::vector<Gripper>& grippers_;
  const std::vector<DetectedObject>& objects_;
  float reach_m_ = 0;
};

NoGrasp::Reason ReasonOf(const Planner::Found& found, const DetectedObject& object) {
  // Where a few are left of many, what the many failed for says more.
  if (found.failures.NumOfMostCommon() < static_cast<int>(found.grasps.size())) {
    return NoGrasp::Reason::kUnlikely;
  }
  if (object.truncated) return NoGrasp::Reason::kCut;
  return found.failures.MostCommon(NoGrasp::Reason::kTooLittleSeen);
}

}  // namespace

void PlanGrasps(const GraspScene& scene, const std::vector<Gripper>& grippers,
                std::vector<DetectedObject>& objects,
                std::vector<std::vector<ScoredGrasp>>* candidates) {
  if (grippers.empty()) return;
  const Planner planner(scene, grippers, objects);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::vector<Planner::Found> found = planner.PlanFor(i);
    std::vector<ScoredGrasp> judged;
    for (std::size_t g = 0; g < grippers.size(); ++g) {
      const std::vector<Grasp> ranked = RankGrasps(found[g].grasps, grippers[g].max_grasps);
      if (ranked.empty()) objects[i].no_grasps.push_back({g, ReasonOf(found[g], objects[i])});
      objects[i].grasps.insert(objects[i].grasps.end(), ranked.begin(), ranked.end());
      judged.insert(judged.end(), found[g].grasps.begin(), found[g].grasps.end());
    }
    if (candidates != nullptr) candidates->push_back(std::move(judged));
  }
}

}  // namespace fovea
