// A floor with things on it and a robot's hand, simulated: what the camera sees, and what becomes
// of a grasp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/types/grasp.h"
#include "core/types/gripper.h"
#include "tests/evaluation/grasp_check/outcome.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

// So many things of a household on the floor of a room, some against others or on them; fewer where
// there is no room or they would hide each other.
scenes::Scene ClutteredFloor(std::uint64_t seed, int num_things);

struct Attempt {
  Grasp grasp;
  std::string name;  // of the thing that the hand moved to; empty: there was none
  Outcome outcome = Outcome::kNoContact;
  bool carried = false;  // the grasp holds, but something stands on the thing: it stays
  bool tipped = false;   // the thing lies now

  bool TookIt() const { return outcome == Outcome::kSuccess && !carried; }
};

class FloorWorld {
 public:
  FloorWorld(scenes::Scene scene, std::vector<Gripper> hands, scenes::SensorKind sensor,
             std::uint64_t seed);

  const scenes::Scene& scene() const { return scene_; }
  const std::vector<Gripper>& hands() const { return hands_; }
  std::size_t NumThings() const { return scenes::ObjectsOf(scene_).size(); }

  // With other noise each time.
  scenes::LabelledFrame Look();

  // Moves the hand `grasp.gripper` in, closes it and lifts (CheckGrasp says how that ends). What it
  // holds is gone, unless something stands on it. What slips out of jaws, or is hit by them, tips
  // over if it is half as high again as wide and there is room. Throws std::invalid_argument for a
  // gripper that the robot does not have.
  Attempt Take(const Grasp& grasp);

  // Whether a search with the true solids finds a grasp for any hand; slow.
  bool CanBeTaken(int label) const;
  // Whether something stands on it.
  bool CarriesAnother(int label) const;

 private:
  bool TipOver(int body, const Eigen::Vector3d& push);

  scenes::Scene scene_;
  const std::vector<Gripper> hands_;
  const scenes::SensorKind sensor_;
  const std::uint64_t seed_;
  std::uint64_t num_looks_ = 0;
};

}  // namespace fovea::evaluation
