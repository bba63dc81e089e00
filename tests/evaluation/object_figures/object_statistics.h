// Figures of boxes, shapes and relations over groups of objects.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/evaluation/object_figures/object_run.h"
#include "tests/evaluation/scores.h"

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

// Of what is seen to ≥ 0.9, to 0.7 … 0.9 and to 0.4 … 0.7: all, by class, by sensor, and flat
// things by sensor; empty groups left out.
std::vector<BoxFigures> BoxFiguresOf(const ObjectRun& run);

// In the order of Shape::Kind.
inline constexpr std::array<const char*, 6> kShapeNames = {"other",  "box",        "cylinder",
                                                           "sphere", "revolution", "flat"};

// How many are [truly this][answered as that].
using Confusions = std::array<std::array<int, kShapeNames.size()>, kShapeNames.size()>;
Confusions ConfusionsOf(const ObjectRun& run);

// Objects whose shape is right, and how many there are: "all", by class and by visibility.
std::map<std::string, std::pair<int, int>> RightShapes(const ObjectRun& run);

Score ScoreOf(const Relations& relations);

// Of all objects, and of what is seen to ≥ 0.9, 0.7 … 0.9 and 0.4 … 0.7.
std::map<std::string, std::vector<Honesty>> HonestiesOf(const ObjectRun& run);

// Things in one colour that are called by its name, and how many there are.
std::pair<int, int> RightColors(const ObjectRun& run);

}  // namespace fovea::evaluation
