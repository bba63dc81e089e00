#include "core/tracking/rigid_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kNumSamples = 256;
constexpr double kMaxError_px = 3;  // of an image 640 wide

// Pixels on both axes, and depth in standard deviations that weigh like one pixel.
using Residual = Eigen::Vector3d;

// Of the first Kinect, the noisiest of those in use: 1.7 mm at 1 m (Khoshelham and Elberink 2012);
// a difference of two, and what corners are beside their pixel.
double DepthDeviation(double depth_m) { return 0.003 + 0.0025 * depth_m * depth_m; }

struct Problem {
  const std::vector<PointPair>& pairs;
  const CameraIntrinsics& k;
  double px;  // of an image 640 wide

  Residual At(const PointPair& pair, const Eigen::Vector3d& p) const {
    return {(k.fx_px * p.x() / p.z() + k.cx_px - pair.to_px.x()) / px,
            (k.fy_px * p.y() / p.z() + k.cy_px - pair.to_px.y()) / px,
            (p.z() - pair.to.z()) / DepthDeviation(pair.to.z())};
  }

  bool Fits(const PointPair& pair, const Eigen::Isometry3d& motion) const {
    const Eigen::Vector3d p = motion * pair.from;
    if (!(p.z() > 0)) return false;
    const Residual r = At(pair, p);
    return r.head<2>().squaredNorm() < kMaxError_px * kMaxError_px &&
           std::abs(r.z()) < kMaxError_px;
  }
};

Eigen::Isometry3d MotionOf(const std::array<const PointPair*, 3>& sample) {
  Eigen::Matrix3d from, to;
  for (int i = 0; i < 3; ++i) {
    from.col(i) = sample[i]->from;
    to.col(i) = sample[i]->to;
  }
  return Eigen::Isometry3d(Eigen::umeyama(from, to, /*with_scaling=*/false));
}

std::vector<char> InliersOf(const Problem& problem, const Eigen::Isometry3d& motion, int* count) {
  std::vector<char> inliers(problem.pairs.size());
  *count = 0;
  for (std::size_t i = 0; i < inliers.size(); ++i) {
    inliers[i] = static_cast<char>(problem.Fits(problem.pairs[i], motion));
    *count += inliers[i];
  }
  return inliers;
}

Eigen::Isometry3d BestOfSamples(const Problem& problem) {
  std::minstd_rand random(1);
  const auto pick = [&] { return &problem.pairs[random() % problem.pairs.size()]; };
  Eigen::Isometry3d best = Eigen::Isometry3d::Identity();
  int most = 0;
  InliersOf(problem, best, &most);
  for (int i = 0; i < kNumSamples; ++i) {
    InterruptionPoint();
    const std::array<const PointPair*, 3> sample = {pick(), pick(), pick()};
    const Eigen::Isometry3d motion = MotionOf(sample);
    if (!motion.matrix().allFinite()) continue;
    int count = 0;
    InliersOf(problem, motion, &count);
    if (count <= most) continue;
    most = count;
    best = motion;
  }
  return best;
}

// The sums of least squares over the inliers; a motion is a small turn and shift before the camera.
struct NormalEquations {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  double squares = 0;

  void Add(const Problem& problem, const PointPair& pair, const Eigen::Vector3d& p) {
    Eigen::Matrix3d by_point;
    const double fx = problem.k.fx_px / problem.px, fy = problem.k.fy_px / problem.px;
    by_point << fx / p.z(), 0, -fx * p.x() / (p.z() * p.z()),  //
        0, fy / p.z(), -fy * p.y() / (p.z() * p.z()),          //
        0, 0, 1 / DepthDeviation(pair.to.z());
    Eigen::Matrix<double, 3, 6> point_by_motion;
    point_by_motion << 0, p.z(), -p.y(), 1, 0, 0,  //
        -p.z(), 0, p.x(), 0, 1, 0,                 //
        p.y(), -p.x(), 0, 0, 0, 1;
    const Eigen::Matrix<double, 3, 6> jacobian = by_point * point_by_motion;
    const Residual residual = problem.At(pair, p);
    matrix += jacobian.transpose() * jacobian;
    gradient += jacobian.transpose() * residual;
    squares += residual.squaredNorm();
  }
};

NormalEquations EquationsAt(const Problem& problem, const RigidMotion& motion,
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

// Moves to the least squares over the inliers. False where these do not determine the motion.
bool Refine(const Problem& problem, RigidMotion& motion) {
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
    Eigen::Matrix<double, 3, 6> mean_by_motion;
    mean_by_motion << 0, mean.z(), -mean.y(), 1, 0, 0,  //
        -mean.z(), 0, mean.x(), 0, 1, 0,                //
        mean.y(), -mean.x(), 0, 0, 0, 1;
    const double variance = sums.squares / std::max(1, 3 * motion.num_inliers - 6);
    const Eigen::Matrix3d covariance =
        variance * mean_by_motion * solver.solve(mean_by_motion.transpose());
    motion.error_m = std::sqrt(std::max(0.0, covariance.trace()));
  }
  return motion.to_from_from.matrix().allFinite() && std::isfinite(motion.error_m);
}

}  // namespace

std::optional<RigidMotion> FindRigidMotion(const std::vector<PointPair>& pairs,
                                           const CameraIntrinsics& intrinsics, int width_px) {
  const int fewest = std::max<int>(kFewestInliers, static_cast<int>(pairs.size() / 4));
  if (static_cast<int>(pairs.size()) < fewest) return std::nullopt;
  const Problem problem{pairs, intrinsics, std::max(1.0, width_px / 640.0)};
  RigidMotion motion;
  motion.to_from_from = BestOfSamples(problem);
  constexpr int kRounds = 2;  // more pairs fit what is refined
  for (int round = 0; round < kRounds; ++round) {
    motion.is_inlier = InliersOf(problem, motion.to_from_from, &motion.num_inliers);
    if (motion.num_inliers < fewest || !Refine(problem, motion)) return std::nullopt;
  }
  return motion;
}

}  // namespace fovea
