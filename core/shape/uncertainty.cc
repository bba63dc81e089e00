#include "core/shape/uncertainty.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/shape/solid_residuals.h"

namespace fovea {
namespace {

using Vector7f = Eigen::Matrix<float, 7, 1>;
using DoubleMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                   kMaxParameters, kMaxParameters>;
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
  // With doubles: of thin solids some numbers are known 10^6 times as well as others. Rounding has
  // made some curvatures negative, which would take away from how vague the others are.
  const Eigen::SelfAdjointEigenSolver<DoubleMatrix> curvatures(
      Linearize(residuals, solid, at, 1).normal.cast<double>());
  const DoubleMatrix& ways = curvatures.eigenvectors();
  DoubleMatrix normal = ways * curvatures.eigenvalues().cwiseMax(0).asDiagonal() * ways.transpose();
  const float vague_m = kVagueShare * solid.Size().maxCoeff();
  for (Eigen::Index k = 0; k < normal.rows(); ++k) {
    const bool is_turn = HasTurn(solid.kind) && k == kTurnParameter;
    const float vague = is_turn ? kVagueTurn_rad : vague_m;
    normal(k, k) += 1 / (vague * vague);
  }
  const auto identity = DoubleMatrix::Identity(normal.rows(), normal.cols());
  return normal.llt().solve(identity).cast<float>();
}

}  // namespace

BoxUncertainty UncertaintyOf(const SeenObject& seen, const Solid& fitted, float cost) {
  // As thick as fitting has it at least: else a step of a thinner one jumps there.
  const Solid solid = Moved(fitted, ParameterVector::Zero(NumParameters(fitted.kind)));
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
