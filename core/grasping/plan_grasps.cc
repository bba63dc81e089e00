#include "core/grasping/plan_grasps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/grasping/clearance.h"
#include "core/grasping/grasp_model.h"
#include "core/grasping/hand_grid.h"
#include "core/grasping/jaw_grasps.h"
#include "core/grasping/ranking.h"
#include "core/grasping/suction_grasps.h"
#include "core/grasping/unseen_way.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

float ExtentOf(const JawGripper& jaw) { return jaw.max_opening_m / 2 + jaw.finger_thickness_m; }

float ExtentOf(const SuctionGripper& cup) { return cup.diameter_m; }

// Around the object, what the widest hand needs.
float ReachOf(const Gripper& gripper) {
  constexpr float kRoom_m = 0.03F;
  return std::visit([](const auto& hand) { return ExtentOf(hand); }, gripper.hand) + kRoom_m;
}

// Hands of which none needs more than twice the room of another share a grid, and so do all that
// need little: a much wider one would have coarser cells.
int WidthClassOf(const Gripper& gripper) {
  constexpr float kLittle_m = 0.12F;
  return std::max(0, std::ilogb(2 * ReachOf(gripper) / kLittle_m));
}

// The ways in that are tried: the preferred one, and where the gripper may tilt nearly that far,
// away from the camera, as level as it may.
std::vector<Eigen::Vector3f> ApproachesOf(const Gripper& gripper, const Eigen::Vector3f& up,
                                          const DetectedObject& object) {
  constexpr float kLevel_rad = 1.4F;
  const Eigen::Vector3f preferred = gripper.approach.value_or(-up);
  std::vector<Eigen::Vector3f> approaches = {preferred};
  if (gripper.max_tilt_rad < kLevel_rad || std::abs(preferred.dot(up)) < 0.5F) return approaches;
  const Eigen::Vector3f away = object.box.center - up * up.dot(object.box.center);
  if (away.norm() <= 0.01F) return approaches;
  const Eigen::Vector3f level = away.normalized();
  // With doubles, whose last bits, which differ between machines, do not show in floats.
  const auto most = static_cast<float>(std::cos(double{gripper.max_tilt_rad}));
  if (preferred.dot(level) >= most) {
    approaches.push_back(level);
  } else {
    const Eigen::Vector3f tilted = (level - preferred * preferred.dot(level)).normalized();
    approaches.push_back((most * preferred + std::sqrt(1 - most * most) * tilted).normalized());
  }
  return approaches;
}

// Of what has no depth its box is a guess, which the model knows nothing of.
void DoubtAll(std::vector<ScoredGrasp>& grasps) {
  constexpr float kHeld = 0.6F;  // of those that it calls sure
  for (ScoredGrasp& scored : grasps) scored.grasp.probability *= kHeld;
}

class Planner {
 public:
  Planner(const GraspScene& scene, const std::vector<Gripper>& grippers,
          const std::vector<DetectedObject>& objects)
      : scene_(scene), grippers_(grippers), objects_(objects) {}

  // What was found for each gripper, and what failed.
  struct Found {
    std::vector<ScoredGrasp> grasps;
    Failures failures;
  };

  std::vector<Found> PlanFor(std::size_t target) const {
    std::vector<Found> found(grippers_.size());
    const Target at = {target, TermsOfObject(scene_, objects_[target])};
    for (const auto& [approach, width_class, grippers] : GroupsFor(objects_[target])) {
      InterruptionPoint();
      float reach_m = 0;
      for (const std::size_t g : grippers) reach_m = std::max(reach_m, ReachOf(grippers_[g]));
      const HandGrid grid = BuildHandGrid(scene_, objects_, target, approach, reach_m);
      FindWithJaws(at, grippers, grid, found);
      FindWithCups(at, grippers, grid, found);
    }
    const GraspModel& model = FittedGraspModel();
    for (Found& own : found) {
      model.SetProbabilities(own.grasps);
      if (objects_[target].depth_missing) DoubtAll(own.grasps);
    }
    return found;
  }

 private:
  struct Target {
    std::size_t index;
    GraspTerms terms;
  };

  // Those that move in the same way and are about as wide share a grid.
  struct Group {
    Eigen::Vector3f approach;
    int width_class;
    std::vector<std::size_t> grippers;
  };

  std::vector<Group> GroupsFor(const DetectedObject& object) const {
    std::vector<Group> groups;
    for (std::size_t g = 0; g < grippers_.size(); ++g) {
      const int width_class = WidthClassOf(grippers_[g]);
      for (const Eigen::Vector3f& approach : ApproachesOf(grippers_[g], scene_.up, object)) {
        auto known = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
          return group.approach == approach && group.width_class == width_class;
        });
        if (known == groups.end()) known = groups.insert(known, {approach, width_class, {}});
        known->grippers.push_back(g);
      }
    }
    return groups;
  }

  void FindWithJaws(const Target& target, const std::vector<std::size_t>& grippers,
                    const HandGrid& grid, std::vector<Found>& found) const {
    std::vector<JawHand> hands;
    for (const std::size_t g : grippers) {
      if (const auto* jaw = std::get_if<JawGripper>(&grippers_[g].hand)) {
        hands.push_back({g, *jaw, {}, {}});
      }
    }
    if (hands.empty()) return;
    FindJawGrasps(scene_, objects_[target.index], target.terms, grid, hands);
    for (JawHand& hand : hands) {
      Found& own = found[hand.gripper];
      std::move(hand.grasps.begin(), hand.grasps.end(), std::back_inserter(own.grasps));
      own.failures.Add(hand.failures);
    }
  }

  void FindWithCups(const Target& target, const std::vector<std::size_t>& grippers,
                    const HandGrid& grid, std::vector<Found>& found) const {
    for (const std::size_t g : grippers) {
      if (!std::holds_alternative<SuctionGripper>(grippers_[g].hand)) continue;
      Found& own = found[g];
      std::vector<ScoredGrasp> grasps = FindSuctionGrasps(
          scene_, objects_[target.index], target.terms, grid, grippers_[g], g, own.failures);
      std::move(grasps.begin(), grasps.end(), std::back_inserter(own.grasps));
    }
  }

  const GraspScene& scene_;
  const std::vector<Gripper>& grippers_;
  const std::vector<DetectedObject>& objects_;
};

NoGrasp::Reason ReasonOf(const Planner::Found& found, const DetectedObject& object) {
  // Where a few are left of many, what the many failed for says more.
  if (found.failures.NumOfMostCommon() < static_cast<int>(found.grasps.size())) {
    return NoGrasp::Reason::kUnlikely;
  }
  if (object.truncated) return NoGrasp::Reason::kCut;
  return found.failures.MostCommon(NoGrasp::Reason::kTooLittleSeen);
}

// The likeliest of those that were found for gripper `g`, or why none of them is offered.
void Offer(const GraspScene& scene, const std::vector<Gripper>& grippers, std::size_t g,
           const Planner::Found& found, std::size_t target, std::vector<DetectedObject>& objects) {
  // A hand that would pass behind something, as below the board of a shelf, meets it nearly always:
  // boards are seen from in front alone.
  constexpr float kMostHidden = 0.5F, kHeld = 0.1F;
  DetectedObject& object = objects[target];
  const auto* jaw = std::get_if<JawGripper>(&grippers[g].hand);
  bool any_hidden = false;
  std::vector<Grasp> ranked = RankGrasps(found.grasps, grippers[g], [&](Grasp& grasp) {
    const UnseenWay way = LookAtWay(scene, object.label, grippers[g], grasp);
    grasp.unseen_way = way.unseen;
    const bool is_hidden = jaw != nullptr && way.hidden > kMostHidden;
    any_hidden = any_hidden || is_hidden;
    return is_hidden ? kHeld : 1;
  });
  if (ranked.empty()) {
    object.no_grasps.push_back(
        {g, any_hidden ? NoGrasp::Reason::kCovered : ReasonOf(found, object)});
  }
  for (Grasp& grasp : ranked) {
    if (jaw != nullptr) grasp.clearance_m = ClearanceOf(scene, objects, target, *jaw, grasp);
    object.grasps.push_back(grasp);
  }
}

}  // namespace

void PlanGrasps(const GraspScene& scene, const std::vector<Gripper>& grippers,
                std::vector<DetectedObject>& objects,
                std::vector<std::vector<ScoredGrasp>>* candidates) {
  if (grippers.empty()) return;
  const Planner planner(scene, grippers, objects);
  if (candidates != nullptr) candidates->resize(objects.size());
  // Planning reads of the others where and what they are, never what they are taken by.
  ForEachTogether(objects.size(), [&](std::size_t i) {
    const std::vector<Planner::Found> found = planner.PlanFor(i);
    for (std::size_t g = 0; g < grippers.size(); ++g) {
      Offer(scene, grippers, g, found[g], i, objects);
      if (candidates != nullptr) {
        std::vector<ScoredGrasp>& judged = (*candidates)[i];
        judged.insert(judged.end(), found[g].grasps.begin(), found[g].grasps.end());
      }
    }
  });
}

}  // namespace fovea
