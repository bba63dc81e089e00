// The object model that makes the objects of labelled scenes most likely.
#pragma once

#include <string>
#include <vector>

#include "core/objects/object_model.h"
#include "tests/evaluation/object_fit/tree_samples.h"

namespace fovea::evaluation {

// Knots at quantiles of each term over all nodes but those of the group `left_out` ("": of none),
// none for terms that are 0 or 1.
ObjectModel ModelWithKnots(const std::vector<TreeSample>& samples, const std::string& left_out);

// Times half of the squares of a function's first slope, and of what each of its knots adds to it,
// on terms scaled to variance 1.
struct FitPenalties {
  double slope = 3;
  double bend = 5;
};

// The model with the knots of `start` under which the true objects of all samples but those of the
// group `left_out`, of which it hears nothing, have the highest probability, with penalties, and
// functions of what is plainly for or against an object that only rise or fall; starts from its
// slopes. L-BFGS within bounds, at most `max_iterations`.
ObjectModel FitModel(const std::vector<TreeSample>& samples, const ObjectModel& start,
                     const std::string& left_out, const FitPenalties& penalties,
                     int max_iterations);

// −ln of the probability of what is true in a sample.
double LossOf(const TreeSample& sample, const ObjectModel& model);

// The source text of core/objects/fitted_object_model.cc.
std::string ToSource(const ObjectModel& model);

}  // namespace fovea::evaluation
