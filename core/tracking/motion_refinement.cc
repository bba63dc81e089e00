#include "core/tracking/motion_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Of the first Kinect, the noisiest of those in use: 1.7 mm at 1 m (Khoshelham and Elberink 2012);
// a difference of two, and what corners are beside their pixel.
double DepthDeviation(double depth_m) { return 0.003 + 0.0025 * depth_m * depth_m; }

// How a point moves with a small turn and shift of all points, in this order.
Eigen::Matrix<double, 3, 6> PointByMotion(const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << 0, p.z(), -p.y(), 1, 0, 0,  //
      -p.z(), 0, p.x(), 0, 1, 0,          //
      p.y(), -p.x(), 0, 0, 0, 1;
  return jacobian;
}

// The sums of least squares over the inliers.
struct NormalEquations {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  double squares = 0;

  void Add(const MotionProblem& problem, const PointPair& pair, const Eigen::Vector3d& p) {
    Eigen::Matrix3d by_point;
    const double fx = problem.k.fx_px / problem.px, fy = problem.k.fy_px / problem.px;
    by_point << fx / p.z(), 0, -fx * p.x() / (p.z() * p.z()),  //
        0, fy / p.z(), -fy * p.y() / (p.z() * p.z()),          //
        0, 0, 1 / DepthDeviation(pair.to.z());
    const Eigen::Matrix<double, 3, 6> jacobian = by_point * PointByMotion(p);
    const Eigen::Vector3d residual = problem.Residual(pair, p);
    matrix += jacobian.transpose() * jacobian;
    gradient += jacobian.transpose() * residual;
    squares += residual.squaredNorm();
  }
};

NormalEquations EquationsAt(const MotionProblem& problem, const RigidMotion& motion,
                            Eigen::Vector3d* mean) {
  NormalEquations sums;
  mean->setZero();
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    if (motion.is_inlier[i] == 0) continue;
    const Eigen::Vector3d p = motion.to_from_from * problem.pairs[i].from;
    sums.Add(problem, problem.pairs[i], p);
    *mean += p / motion.num_inliers;
  }
  return sums;
}

Eigen::Isometry3d Step(const Eigen::Matrix<double, 6, 1>& twist) {
  const double angle = twist.head<3>().norm();
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  if (angle > 0) step.linear() = Eigen::AngleAxisd(angle, twist.head<3>() / angle).matrix();
  step.translation() = twist.tail<3>();
  return step;
}

}  // namespace

Eigen::Vector3d MotionProblem::Residual(const PointPair& pair, const Eigen::Vector3d& p) const {
  return {(k.fx_px * p.x() / p.z() + k.cx_px - pair.to_px.x()) / px,
          (k.fy_px * p.y() / p.z() + k.cy_px - pair.to_px.y()) / px,
          (p.z() - pair.to.z()) / DepthDeviation(pair.to.z())};
}

bool Refine(const MotionProblem& problem, RigidMotion& motion) {
  constexpr int kIterations = 5;
  for (int i = 0; i <= kIterations; ++i) {
    Eigen::Vector3d mean;
    const NormalEquations sums = EquationsAt(problem, motion, &mean);
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(sums.matrix);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-12)) return false;
    if (i < kIterations) {
      motion.to_from_from = Step(-solver.solve(sums.gradient)) * motion.to_from_from;
      continue;
    }
    const Eigen::Matrix<double, 3, 6> mean_by_motion = PointByMotion(mean);
    const double variance = sums.squares / std::max(1, 3 * motion.num_inliers - 6);
    const Eigen::Matrix3d covariance =
        variance * mean_by_motion * solver.solve(mean_by_motion.transpose());
    motion.error_m = std::sqrt(std::max(0.0, covariance.trace()));
  }
  return motion.to_from_from.matrix().allFinite() && std::isfinite(motion.error_m);
}

}  // namespace fovea
