// Counts of grasps over groups of objects.
#pragma once

#include <string>
#include <vector>

#include "tests/evaluation/grasp_figures/grasp_run.h"
#include "tests/evaluation/reliability.h"

namespace fovea::evaluation {

struct GripperFigures {
  int objects = 0, offered = 0, first = 0, any = 0;  // first: the first grasp succeeds
  int searched = 0, possible = 0;  // whether there is a grasp at all was looked for, and there is
  int none = 0, none_right = 0;    // none was offered, and the search finds none

  double FirstShare() const { return objects > 0 ? double(first) / objects : 0; }
};

struct GroupFigures {
  std::string name;
  std::vector<GripperFigures> grippers;  // as EvaluationGrippers()
  std::vector<int> with_cup;             // the first grasp of this one or of the cup succeeds
};

struct Grouping {
  std::string by;
  std::vector<GroupFigures> groups;
};

// "all", then by "class", "visibility", "sensor" and "kind".
std::vector<Grouping> FiguresOf(const GraspRun& run);

// The probability of each first grasp, and whether it succeeds: what is offered first is what a
// robot takes.
std::vector<Prediction> PredictionsOf(const GraspRun& run, std::size_t gripper);

// How many first grasps end so, by Outcome.
std::vector<int> OutcomesOf(const GraspRun& run, std::size_t gripper);

}  // namespace fovea::evaluation
