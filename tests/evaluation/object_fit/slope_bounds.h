// Which slopes the functions of the object model may have.
#pragma once

#include <Eigen/Core>

#include "core/objects/object_model.h"
#include "tests/evaluation/term_columns.h"

namespace fovea::evaluation {

constexpr std::size_t kNumSlopes = kNumObjectTerms * kColumnsOfTerm;
constexpr double kNoBound = 1e6;  // of scaled slopes

// Of slopes between knots, in the order of the terms. What most plainly speaks for an object never
// speaks against one, and the other way round: the few frames that there are say otherwise now and
// then, which is chance.
Eigen::VectorXd LowerBounds();
Eigen::VectorXd UpperBounds();

// The slopes of functions between their knots, where bounds are plain, in place of the first one
// and what each knot adds to it; each scaled as its column is. What follows the slopes stays.
class SlopesBetweenKnots {
 public:
  // `scale`: of each column.
  SlopesBetweenKnots(const ObjectModel& knots, const Eigen::VectorXd& scale);

  Eigen::VectorXd ToAdded(const Eigen::VectorXd& between) const;
  Eigen::VectorXd FromAdded(const Eigen::VectorXd& added) const;
  // The gradient by slopes between knots, from that by what knots add.
  Eigen::VectorXd GradientOf(const Eigen::VectorXd& by_added) const;

 private:
  Eigen::VectorXd ratios_;  // of the scales of a column and the one before it; 0 where none bends
};

}  // namespace fovea::evaluation
