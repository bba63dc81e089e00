// What is said of the objects of generated scenes, beside what is true.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types/shape.h"
#include "tests/evaluation/generated/generated_flags.h"
#include "tests/evaluation/object_figures/box_errors.h"
#include "tests/evaluation/object_figures/box_honesty.h"

namespace fovea::evaluation {

struct DescribedObject {
  std::string kind, sensor, name, what;
  std::uint64_t seed = 0;
  double visible_share = 0;
  BoxErrors box;
  Shape::Kind true_shape = Shape::Kind::kOther, answered_shape = Shape::Kind::kOther;
  bool shape_is_right = false;  // any of TrueClass::accepted
  double shape_confidence = 0;
  double unseen_share = 0;
  UncertainBox uncertain;
  std::optional<bool> color_is_right;  // the name of its largest part; of things in one colour
};

// Pairs of matched objects of which one stands on the other.
struct Relations {
  int truth = 0, answered = 0, right = 0;
};

struct ObjectRun {
  std::vector<DescribedObject> objects;  // matched ones, in the order of scenes, sensors and labels
  Relations on_objects;
  Relations leaning;
  // Matched objects whose stands_on is exactly right, furniture and nothing answered taken for the
  // same; objects that were not matched count as furniture on both sides.
  int stands_right = 0;
  std::vector<double> num_objects;  // of each frame
  std::vector<double> objects_ms;   // and its stage "objects"
};

// What the stage takes where there are ten objects: what each of them adds to what it takes anyway.
double TenObjectsMs(const ObjectRun& run);

ObjectRun RunObjects(const GeneratedFlags& flags);

}  // namespace fovea::evaluation
