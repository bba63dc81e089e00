// How the grasps that are answered for generated scenes end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types/gripper.h"
#include "tests/evaluation/generated/generated_flags.h"
#include "tests/evaluation/grasp_check/outcome.h"

namespace fovea::evaluation {

// One gripper at one matched object.
struct GripperResult {
  std::vector<Outcome> outcomes;  // of the grasps that were offered, in their order
  std::vector<double> probabilities;
  std::vector<double> unseen_ways;  // of each, Grasp::unseen_way
  std::optional<bool>
      possible;  // whether a search with the true solids finds a grasp, if asked for
  // Of the candidates that were judged, offered or not, if asked for: their outcomes, likeliest
  // first, and probabilities.
  std::vector<Outcome> candidate_outcomes;
  std::vector<double> candidate_probabilities;
  int reason = -1;  // of none offered, NoGrasp::Reason; -1 = none was given

  bool FirstSucceeds() const { return !outcomes.empty() && outcomes.front() == Outcome::kSuccess; }
  bool AnySucceeds(std::size_t most = 5) const;
};

struct GraspedObject {
  std::string kind, sensor, name, what;
  std::uint64_t seed = 0;
  double visible_share = 0;
  std::vector<GripperResult> grippers;  // in the order of Grippers()
};

// A jaw that opens to 85 mm, one to 140 mm and a suction cup of 30 mm, all else as usual.
std::vector<Gripper> EvaluationGrippers();

struct GraspRun {
  std::vector<GraspedObject> objects;  // matched ones, in the order of scenes, sensors and labels
  std::size_t num_truth = 0;           // that show at least one pixel
  std::vector<double> num_objects;     // of each frame
  std::vector<double> grasps_ms;       // and its stage "grasps"
};

struct GraspQuestions {
  bool possible = false;    // whether there is a grasp at all: a second for each object and gripper
  bool candidates = false;  // how those end that were judged, up to 400 of each object and gripper
  float min_probability = Gripper{}.min_probability;  // of what is offered
};

// Writes pictures to flags.overlays, if any.
GraspRun RunGrasps(const GeneratedFlags& flags, const GraspQuestions& questions);

}  // namespace fovea::evaluation
