#include "core/shape/uncertainty.h"

#include <Eigen/LU>
#include <cmath>

#include "core/shape/solid_residuals.h"

namespace fovea {
namespace {

using Vector7f = Eigen::Matrix<float, 7, 1>;
using BoxDerivatives = Eigen::Matrix<float, 7, Eigen::Dynamic, Eigen::ColMajor, 7, kMaxParameters>;

// Where neither points nor outline say anything: standard deviations of places and sizes as shares
// of the largest size, and of a turn.
constexpr float kVagueShare = 0.25F, kVagueTurn_rad = 0.5F;
// What the errors of generated scenes are in these (middle, turn, sizes), and what all of them have
// in common, of calibration and of outlines.
constexpr float kStretchOfMiddle = 1.35F, kStretchOfTurn = 1, kStretchOfSize = 1.15F;
constexpr float kCommonOfMiddle_m = 0.0007F, kCommonOfSize_m = 0.0018F;

// Middle, then sizes; a turn has no place in it.
Eigen::Matrix<float, 6, 1> BoxAround(const Solid& solid) {
  const Eigen::Vector3f size = solid.Size();
  Eigen::Matrix<float, 6, 1> box;
  box << solid.center, size.z() / 2, size;
  return box;
}

// Of middle, turn and sizes by the solid's numbers.
BoxDerivatives Derivatives(const Solid& solid) {
  constexpr float kMillimetre = 1e-3F;  // metres; of a function that is linear
  const int count = NumParameters(solid.kind);
  BoxDerivatives derivatives(7, count);
  for (int k = 0; k < count; ++k) {
    const Solid moved = Moved(solid, ParameterVector::Unit(count, k) * kMillimetre);
    const Eigen::Matrix<float, 6, 1> change = (BoxAround(moved) - BoxAround(solid)) / kMillimetre;
    const float turn = HasTurn(solid.kind) && k == kTurnParameter ? 1 : 0;
    derivatives.col(k) << change.head<3>(), turn, change.tail<3>();
  }
  return derivatives;
}

ParameterMatrix ParameterCovariance(const SeenObject& seen, const Solid& solid) {
  SolidResiduals residuals(seen);
  const SeenArray at = residuals.Of(solid);
  ParameterMatrix normal = Linearize(residuals, solid, at, 1).normal;
  const float vague_m = kVagueShare * solid.Size().maxCoeff();
  for (Eigen::Index k = 0; k < normal.rows(); ++k) {
    const bool is_turn = HasTurn(solid.kind) && k == kTurnParameter;
    const float vague = is_turn ? kVagueTurn_rad : vague_m;
    normal(k, k) += 1 / (vague * vague);
  }
  return normal.inverse();
}

}  // namespace

BoxUncertainty UncertaintyOf(const SeenObject& seen, const Solid& solid, float cost) {
  const auto derivatives = Derivatives(solid);
  Vector7f stretch, common;
  stretch << Eigen::Vector3f::Constant(kStretchOfMiddle), kStretchOfTurn,
      Eigen::Vector3f::Constant(kStretchOfSize);
  common << Eigen::Vector3f::Constant(kCommonOfMiddle_m), 0,
      Eigen::Vector3f::Constant(kCommonOfSize_m);
  stretch *= 1 + cost;  // of what a solid explains less, it says less
  const BoxDerivatives stretched = stretch.asDiagonal() * derivatives;
  Eigen::Matrix<float, 7, 7> covariance =
      stretched * ParameterCovariance(seen, solid) * stretched.transpose();
  covariance = (covariance + covariance.transpose()).eval() / 2;  // but for rounding it is that
  covariance.diagonal() += common.cwiseAbs2();
  return {covariance.topLeftCorner<4, 4>(), covariance.diagonal().tail<3>().cwiseSqrt()};
}

}  // namespace fovea
