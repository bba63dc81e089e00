// Figures of grasps as text, JSON and a chart.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>

#include "tests/evaluation/grasp_figures/grasp_run.h"
#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

// Counts over a group of objects.
struct GripperFigures {
  int objects = 0, offered = 0, first = 0, any = 0;  // first: the first grasp succeeds
  int possible = 0;                                  // 0 without the search
  int none = 0, none_right = 0;                      // none was offered, and the search finds none

  double FirstShare() const { return objects > 0 ? double(first) / objects : 0; }
};

struct GroupFigures {
  std::string name;
  std::vector<GripperFigures> grippers;
  std::vector<int> jaw_or_suction;  // of each jaw: its first grasp or suction's succeeds
};

// All objects, then by class, visibility, sensor and kind.
std::vector<std::vector<GroupFigures>> FiguresOf(const GraspRun& run);

void PrintGrasps(std::ostream& out, const GraspRun& run);
nlohmann::json ToJson(const GraspRun& run);
std::vector<Chart> GraspCharts(const GraspRun& run);

}  // namespace fovea::evaluation
