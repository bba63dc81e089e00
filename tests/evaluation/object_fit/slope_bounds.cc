#include "tests/evaluation/object_fit/slope_bounds.h"

namespace fovea::evaluation {
namespace {

// 1: the function may only rise, -1: only fall, 0: either.
int DirectionOf(ObjectTerm term) {
  switch (term) {
    case ObjectTerm::kFlat:
    case ObjectTerm::kClosed:
    case ObjectTerm::kEndsAnywhere:
    case ObjectTerm::kUnmeasured:
    case ObjectTerm::kLevelSegment:
      return -1;
    case ObjectTerm::kContrast:
      return 1;
    default:
      return 0;
  }
}

// 0 for functions that may not go to that side.
Eigen::VectorXd Bounds(int side) {
  Eigen::VectorXd bounds(kNumSlopes);
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    const int direction = DirectionOf(static_cast<ObjectTerm>(i / kColumnsOfTerm));
    bounds[static_cast<Eigen::Index>(i)] = direction == -side ? 0 : side * kNoBound;
  }
  return bounds;
}

}  // namespace

Eigen::VectorXd LowerBounds() { return Bounds(-1); }
Eigen::VectorXd UpperBounds() { return Bounds(1); }

SlopesBetweenKnots::SlopesBetweenKnots(const ObjectModel& knots, const Eigen::VectorXd& scale)
    : ratios_(Eigen::VectorXd::Zero(kNumSlopes)) {
  for (std::size_t i = 0; i < kNumSlopes; ++i) {
    const std::size_t k = i % kColumnsOfTerm;
    if (k == 0 || knots.functions[i / kColumnsOfTerm].knots[k - 1] >= TermFunction::kNoKnot) {
      continue;
    }
    const auto c = static_cast<Eigen::Index>(i);
    ratios_[c] = scale[c] / scale[c - 1];
  }
}

Eigen::VectorXd SlopesBetweenKnots::ToAdded(const Eigen::VectorXd& between) const {
  Eigen::VectorXd added = between;
  for (Eigen::Index c = 1; c < ratios_.size(); ++c) added[c] -= ratios_[c] * between[c - 1];
  return added;
}

Eigen::VectorXd SlopesBetweenKnots::FromAdded(const Eigen::VectorXd& added) const {
  Eigen::VectorXd between = added;
  for (Eigen::Index c = 1; c < ratios_.size(); ++c) between[c] += ratios_[c] * between[c - 1];
  return between;
}

Eigen::VectorXd SlopesBetweenKnots::GradientOf(const Eigen::VectorXd& by_added) const {
  Eigen::VectorXd gradient = by_added;
  for (Eigen::Index c = 1; c < ratios_.size(); ++c) gradient[c - 1] -= ratios_[c] * by_added[c];
  return gradient;
}

}  // namespace fovea::evaluation
