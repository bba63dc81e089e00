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

// The decisions of joining a scene's segments if all of them are right: the most likely pair that
// is left, one after the other. Of the pairs of two objects only the likeliest, for one wrong join
// is enough. Pairs with a segment of several objects are left out.
std::vector<KinshipSample> SampleKinship(const Scene& scene, const DetectorOptions& options);

}  // namespace fovea::evaluation
