// Pairs of touching segments of labelled scenes, and whether they are parts of one object.
#pragma once

#include <vector>

#include "core/options.h"
#include "core/segmentation/kinship.h"
#include "tests/evaluation/dataset.h"

namespace fovea::evaluation {

struct KinshipSample {
  Kinship kinship;
  bool one_object = false;
  // How much it matters: the share of its object that the smaller segment is, little for specks and
  // for what is no object.
  double weight = 0;
};

// All pairs of a scene's segments, and those that arise while the right ones are joined, the most
// likely first. Pairs with a segment of several objects are left out.
std::vector<KinshipSample> SampleKinship(const Scene& scene, const DetectorOptions& options);

}  // namespace fovea::evaluation
