#include "core/scene/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/types/interruption.h"

namespace fovea {

SupportSurface FitPlane(const std::vector<Eigen::Vector3f>& points,
                        const Eigen::Vector3f& towards) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double total = 0;
  LongLoop loop;
  for (const Eigen::Vector3f& point : points) {
    loop.Turn();
    const Eigen::Vector3d p = point.cast<double>();
    const double weight = 1 / std::max(1e-4, p.z() * p.z() * p.z() * p.z());
    total += weight;
    mean += weight * p;
    moments += weight * p * p.transpose();
  }
  mean /= total;
  const Eigen::Matrix3d covariance = moments / total - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(towards.cast<double>()) < 0) normal = -normal;
  return {normal.cast<float>(), static_cast<float>(-normal.dot(mean)), points.size()};
}

}  // namespace fovea
