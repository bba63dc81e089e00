// Figures of boxes, shapes and relations as text, JSON and a chart.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <ostream>

#include "tests/evaluation/object_figures/object_run.h"
#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

struct MedianAndTail {
  double median = 0, tail = 0;  // of errors the 90th percentile, of IoU the tenth
};

// Over a group of objects. Sizes are absolute errors in mm.
struct BoxFigures {
  std::string name;
  std::size_t count = 0, num_with_yaw = 0;
  std::array<MedianAndTail, 3> size_mm;  // length, width, height
  MedianAndTail center_mm, yaw_deg, iou;
};

// Of what is seen to ≥ 0.9, to 0.7 … 0.9 and to 0.4 … 0.7: all, by class, flat things and balls
// among them, and by sensor; empty groups left out.
std::vector<BoxFigures> BoxFiguresOf(const ObjectRun& run);

void PrintObjects(std::ostream& out, const ObjectRun& run);
nlohmann::json ToJson(const ObjectRun& run);
std::vector<Chart> ObjectCharts(const ObjectRun& run);

}  // namespace fovea::evaluation
