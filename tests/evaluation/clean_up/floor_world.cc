#include "tests/evaluation/clean_up/floor_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "tests/evaluation/grasp_check/check_grasp.h"
#include "tests/evaluation/grasp_check/grasp_search.h"
#include "tests/evaluation/grasp_check/physical_scene.h"
#include "tests/evaluation/object_figures/true_supports.h"
#include "tests/support/random_objects.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

constexpr int kNoBody = -1;

// What the middle of the hand comes to first on its way in, from 150 mm before the tool centre
// point to 30 mm beyond.
int BodyAhead(const PhysicalScene& physical, const Eigen::Vector3d& tip,
              const Eigen::Vector3d& approach) {
  constexpr double kBefore_m = 0.15, kBeyond_m = 0.03;
  const auto met = physical.Nearest({tip - kBefore_m * approach, approach});
  if (!met || met->hit.t > kBefore_m + kBeyond_m) return kNoBody;
  const bool is_thing = physical.Scene().bodies[static_cast<std::size_t>(met->body)].is_object;
  return is_thing ? met->body : kNoBody;
}

// The thing that the hand holds in the end, or else the one that it moved to.
std::pair<int, Outcome> HeldOrMet(const PhysicalScene& physical, const Gripper& hand,
                                  const Grasp& grasp) {
  const std::vector<scenes::Body>& bodies = physical.Scene().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].is_object) continue;
    const int body = static_cast<int>(i);
    if (CheckGrasp(physical, body, hand, grasp) == Outcome::kSuccess) {
      return {body, Outcome::kSuccess};
    }
  }
  const Eigen::Isometry3d& world_from_camera = physical.Scene().camera.world_from_camera;
  const int ahead =
      BodyAhead(physical, world_from_camera * grasp.tool_center_point.cast<double>(),
                world_from_camera.linear() * grasp.approach.cast<double>().normalized());
  if (ahead == kNoBody) return {kNoBody, Outcome::kNoContact};
  return {ahead, CheckGrasp(physical, ahead, hand, grasp)};
}

int LabelOf(const scenes::Scene& scene, int body) {
  return static_cast<int>(std::count_if(scene.bodies.begin(), scene.bodies.begin() + body + 1,
                                        [](const scenes::Body& b) { return b.is_object; }));
}

}  // namespace

scenes::Scene ClutteredFloor(std::uint64_t seed, int num_things) {
  return scenes::RandomScene(scenes::Recipe{"clean_up",
                                            scenes::Surfaces::kFloor,
                                            num_things,
                                            num_things,
                                            0.42,
                                            0.15,
                                            0.1,
                                            {45, 62},
                                            {1.15, 1.35},
                                            false,
                                            scenes::Objects::kMixed},
                             seed);
}

FloorWorld::FloorWorld(scenes::Scene scene, std::vector<Gripper> hands, scenes::SensorKind sensor,
                       std::uint64_t seed)
    : scene_(std::move(scene)), hands_(std::move(hands)), sensor_(sensor), seed_(seed) {}

scenes::LabelledFrame FloorWorld::Look() {
  constexpr std::uint64_t kMostLooks = 1000;
  return scenes::MakeFrame(scene_, sensor_, seed_ * kMostLooks + num_looks_++);
}

Attempt FloorWorld::Take(const Grasp& grasp) {
  if (grasp.gripper >= hands_.size()) {
    throw std::invalid_argument("the robot has " + std::to_string(hands_.size()) +
                                " grippers, and none with index " + std::to_string(grasp.gripper));
  }
  const Gripper& hand = hands_[grasp.gripper];
  const auto [body, outcome] = HeldOrMet(PhysicalScene(scene_), hand, grasp);
  Attempt attempt{grasp, "", outcome, false, false};
  if (body == kNoBody) return attempt;
  attempt.name = scene_.bodies[static_cast<std::size_t>(body)].name;
  attempt.carried = outcome == Outcome::kSuccess && CarriesAnother(LabelOf(scene_, body));
  if (attempt.TookIt()) {
    scene_.bodies.erase(scene_.bodies.begin() + body);
  } else if (std::holds_alternative<JawGripper>(hand.hand) &&
             (outcome == Outcome::kSlips || outcome == Outcome::kHitsTarget)) {
    attempt.tipped =
        TipOver(body, scene_.camera.world_from_camera.linear() * grasp.closing.cast<double>());
  }
  return attempt;
}

bool FloorWorld::TipOver(int index, const Eigen::Vector3d& push) {
  constexpr double kSlender = 1.5;
  scenes::Body& body = scene_.bodies[static_cast<std::size_t>(index)];
  const auto [low, high] = VerticalExtent(body);
  const Eigen::Matrix3d axes = body.world_from_body.linear();
  int up = 0;
  axes.row(2).cwiseAbs().maxCoeff(&up);
  const int first = (up + 1) % 3, second = (up + 2) % 3;
  const double width = std::min(body.shape.size_m[first], body.shape.size_m[second]);
  if (high - low < kSlender * width || CarriesAnother(LabelOf(scene_, index))) return false;
  // Towards its thinner side, where the fingers push; about the axis of the body across that.
  const int across = body.shape.size_m[first] <= body.shape.size_m[second] ? second : first;
  Eigen::Vector3d away = axes.col(across).cross(Eigen::Vector3d::UnitZ());
  if (away.dot(push) < 0) away = -away;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector3d about = Eigen::Vector3d::UnitZ().cross(side * away);
    scenes::Body lying = body;
    lying.world_from_body.linear() =
        Eigen::AngleAxisd(std::numbers::pi / 2, about.normalized()).matrix() * axes;
    const Eigen::Vector3d moved =
        body.world_from_body.translation() + side * away * (high - low) / 2;
    Rest(lying, moved.head<2>(), low, 0);
    const bool is_clear = std::none_of(
        scene_.bodies.begin(), scene_.bodies.end(),
        [&](const scenes::Body& other) { return &other != &body && Overlap(lying, other); });
    if (!is_clear) continue;
    body = lying;
    return true;
  }
  return false;
}

bool FloorWorld::CanBeTaken(int label) const {
  const PhysicalScene physical(scene_);
  return std::any_of(hands_.begin(), hands_.end(), [&](const Gripper& hand) {
    return IsPossible(physical, physical.BodyOf(label), hand);
  });
}

bool FloorWorld::CarriesAnother(int label) const {
  const auto supports = TrueSupports(scene_);
  return std::any_of(supports.begin(), supports.end(), [&](const std::vector<int>& below) {
    return std::find(below.begin(), below.end(), label) != below.end();
  });
}

}  // namespace fovea::evaluation
