#include "core/scene/gravity.h"

#include <Eigen/Eigenvalues>
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

}  // namespace

Eigen::Vector3f EstimateGravity(const cv::Mat& normals, const GravityOptions& options) {
  const std::vector<Eigen::Vector3d> valid = ValidNormals(normals);
  Eigen::Vector3d down = Eigen::Vector3d::UnitY();
  for (const double angle_deg : {options.coarse_angle_deg, options.fine_angle_deg}) {
    for (int i = 0; i < options.iterations; ++i) {
      down = Refine(valid, down, angle_deg * std::numbers::pi / 180);
    }
  }
  return down.cast<float>();
}

}  // namespace fovea
