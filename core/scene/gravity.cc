#include "core/scene/gravity.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fovea {
namespace {

std::vector<Eigen::Vector3d> ValidNormals(const cv::Mat& normals) {
  std::vector<Eigen::Vector3d> valid;
  for (int row = 0; row < normals.rows; ++row) {
    for (int col = 0; col < normals.cols; ++col) {
      const cv::Vec3f& n = normals.at<cv::Vec3f>(row, col);
      if (!std::isnan(n[0])) valid.emplace_back(n[0], n[1], n[2]);
    }
  }
  return valid;
}

Eigen::Vector3d Refine(const std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& down,
                       double angle_rad) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& n : normals) {
    const double c = std::abs(n.dot(down));
    if (c > std::cos(angle_rad)) {
      scatter -= n * n.transpose();  // floor-like: wants to be parallel
    } else if (c < std::sin(angle_rad)) {
      scatter += n * n.transpose();  // wall-like: wants to be orthogonal
    }
  }
  if (scatter.isZero()) return down;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d refined = solver.eigenvectors().col(0);  // eigenvalues ascend
  return refined.dot(down) < 0 ? -refined : refined;
}

Eigen::Vector3d RefineFrom(Eigen::Vector3d down, const std::vector<Eigen::Vector3d>& normals,
                           const GravityOptions& options) {
  for (const double angle_deg : {options.coarse_angle_deg, options.fine_angle_deg}) {
    for (int i = 0; i < options.iterations; ++i) {
      down = Refine(normals, down, angle_deg * std::numbers::pi / 180);
    }
  }
  return down;
}

// How many normals a direction explains: level surfaces that face up count full, walls half, as
// any direction in a wall explains it.
double Support(const std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& down) {
  const double gate = 10 * std::numbers::pi / 180;
  double support = 0;
  for (const Eigen::Vector3d& n : normals) {
    const double c = n.dot(down);
    if (c < -std::cos(gate)) support += 1;
    if (std::abs(c) < std::sin(gate)) support += 0.5;
  }
  return support;
}

}  // namespace

Eigen::Vector3f EstimateGravity(const cv::Mat& normals, const GravityOptions& options) {
  const std::vector<Eigen::Vector3d> valid = ValidNormals(normals);
  Eigen::Vector3d best = Eigen::Vector3d::UnitY();
  double best_support = -1;
  for (int start = 0; start < options.num_starts; ++start) {
    const double pitch = start * std::numbers::pi / 2 / std::max(1, options.num_starts - 1);
    const Eigen::Vector3d down = RefineFrom({0, std::cos(pitch), std::sin(pitch)}, valid, options);
    const double support = Support(valid, down);
    if (support > best_support) {
      best_support = support;
      best = down;
    }
  }
  return best.cast<float>();
}

}  // namespace fovea
