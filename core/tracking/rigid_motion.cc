#include "core/tracking/rigid_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/tracking/motion_refinement.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kNumSamples = 256;
constexpr double kMaxError_px = 3;  // of an image 640 wide; and standard deviations of depth

bool Fits(const MotionProblem& problem, const PointPair& pair, const Eigen::Isometry3d& motion) {
  const Eigen::Vector3d p = motion * pair.from;
  if (!(p.z() > 0)) return false;
  const Eigen::Vector3d residual = problem.Residual(pair, p);
  return residual.head<2>().squaredNorm() < kMaxError_px * kMaxError_px &&
         std::abs(residual.z()) < kMaxError_px;
}

Eigen::Isometry3d MotionOf(const std::array<const PointPair*, 3>& sample) {
  Eigen::Matrix3d from, to;
  for (int i = 0; i < 3; ++i) {
    from.col(i) = sample[i]->from;
    to.col(i) = sample[i]->to;
  }
  return Eigen::Isometry3d(Eigen::umeyama(from, to, /*with_scaling=*/false));
}

std::vector<char> InliersOf(const MotionProblem& problem, const Eigen::Isometry3d& motion,
                            int* count) {
  std::vector<char> inliers(problem.pairs.size());
  *count = 0;
  for (std::size_t i = 0; i < inliers.size(); ++i) {
    inliers[i] = static_cast<char>(Fits(problem, problem.pairs[i], motion));
    *count += inliers[i];
  }
  return inliers;
}

Eigen::Isometry3d BestOfSamples(const MotionProblem& problem) {
  std::minstd_rand random(1);
  const auto pick = [&] { return &problem.pairs[random() % problem.pairs.size()]; };
  Eigen::Isometry3d best = Eigen::Isometry3d::Identity();
  int most = 0;
  InliersOf(problem, best, &most);
  for (int i = 0; i < kNumSamples; ++i) {
    InterruptionPoint();
    const std::array<const PointPair*, 3> sample = {pick(), pick(), pick()};
    const Eigen::Isometry3d motion = MotionOf(sample);
    int count = 0;
    InliersOf(problem, motion, &count);
    if (count <= most) continue;
    most = count;
    best = motion;
  }
  return best;
}

}  // namespace

std::optional<RigidMotion> FindRigidMotion(const std::vector<PointPair>& pairs,
                                           const CameraIntrinsics& intrinsics, int width_px) {
  const int fewest = std::max<int>(kFewestInliers, static_cast<int>(pairs.size() / 4));
  if (static_cast<int>(pairs.size()) < fewest) return std::nullopt;
  const MotionProblem problem{pairs, intrinsics, std::max(1.0, width_px / 640.0)};
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
