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

// The model with the knots of `start` under which the true objects of all samples but those of the
// group `left_out`, of which it hears nothing, have the highest probability, with a penalty of
// `penalty` / 2 · |slopes|² on terms scaled to variance 1; starts from its slopes. L-BFGS, at most
// `max_iterations`.
ObjectModel FitModel(const std::vector<TreeSample>& samples, const ObjectModel& start,
                     const std::string& left_out, double penalty, int max_iterations);

// −ln of the probability of what is true in a sample.
double LossOf(const TreeSample& sample, const ObjectModel& model);

// The source text of core/objects/fitted_object_model.cc.
std::string ToSource(const ObjectModel& model);

}  // namespace fovea::evaluation
