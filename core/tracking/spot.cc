#include "core/tracking/spot.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Of the centroid of what is seen of a thing that stands: masks end here and there.
double CentroidVariance(const Spot& spot) {
  const double deviation_m = 0.001 + 0.006 * spot.size_m.norm();
  return deviation_m * deviation_m;
}

// Of the difference of two centres. What is well seen in one of the two tells by as much: the
// centroids, which are not in it, say whether it is the other one that errs.
Eigen::Matrix3f CenterCovariance(const Spot& a, const Spot& b) {
  const bool a_is_surer = a.center_covariance.trace() < b.center_covariance.trace();
  return 2 * (a_is_surer ? a : b).center_covariance;
}

double SquaredSigmas(const Eigen::Vector3f& offset, const Eigen::Matrix3f& covariance) {
  // A tenth of a millimetre at least, so that there is an inverse.
  const Eigen::Matrix3d sum = covariance.cast<double>() + 1e-8 * Eigen::Matrix3d::Identity().eval();
  const Eigen::Vector3d off = offset.cast<double>();
  return off.dot(sum.llt().solve(off));
}

}  // namespace

Spot SpotOf(const Sighting& sighting) {
  Eigen::Vector3f size = sighting.box.size_m;
  Spot spot;
  spot.center = sighting.box.center;
  spot.centroid = sighting.centroid;
  if (sighting.uncertainty) {
    spot.center_covariance = sighting.uncertainty->pose_covariance.topLeftCorner<3, 3>();
    spot.size_sigma_m = sighting.uncertainty->size_sigma_m;
  } else {
    const auto within_m = 0.015F + 0.2F * size.norm();
    const float deviation_m =
        within_m / static_cast<float>(std::sqrt(2) * Displacement::kMovedBeyond);
    spot.center_covariance = deviation_m * deviation_m * Eigen::Matrix3f::Identity();
    spot.size_sigma_m.setConstant(within_m / 9);
  }
  if (size.x() < size.y()) {
    std::swap(size.x(), size.y());
    std::swap(spot.size_sigma_m.x(), spot.size_sigma_m.y());
  }
  spot.size_m = size;
  spot.visible_m2 = sighting.visible_m2;
  return spot;
}

Spot Moved(Spot spot, const Eigen::Isometry3f& to_from_own) {
  spot.center = to_from_own * spot.center;
  spot.centroid = to_from_own * spot.centroid;
  const Eigen::Matrix3f turn = to_from_own.linear();
  spot.center_covariance = (turn * spot.center_covariance * turn.transpose()).eval();
  return spot;
}

void Mix(Spot& spot, const Spot& other, float weight) {
  spot.center += weight * (other.center - spot.center);
  spot.centroid += weight * (other.centroid - spot.centroid);
  spot.center_covariance += weight * (other.center_covariance - spot.center_covariance);
  spot.size_m += weight * (other.size_m - spot.size_m);
  spot.size_sigma_m += weight * (other.size_sigma_m - spot.size_sigma_m);
  spot.visible_m2 += weight * (other.visible_m2 - spot.visible_m2);
  spot.camera_variance_m2 *= (1 - weight) * (1 - weight);
}

bool LooksAlike(const Spot& a, const Spot& b) {
  constexpr float kSameArea = 0.15F, kSameSize_m = 0.003F, kSizeSigmas = 3;
  const auto [less, more] = std::minmax(a.visible_m2, b.visible_m2);
  const float stretch = kSizeSigmas * std::sqrt(2.0F);
  const Eigen::Array3f within =
      kSameSize_m + stretch * a.size_sigma_m.cwiseMax(b.size_sigma_m).array();
  return more <= (1 + kSameArea) * less && ((a.size_m - b.size_m).array().abs() < within).all();
}

bool Displacement::IsBeyond(double sigmas) const {
  const float shorter = std::min(of_center.squaredNorm(), of_centroid.squaredNorm());
  return center_sigmas > sigmas && centroid_sigmas > sigmas &&
         of_center.dot(of_centroid) > shorter / 2;
}

Displacement Between(const Spot& from, const Spot& to, const Scatter& scatter,
                     double camera_error_m) {
  const double camera_variance = from.camera_variance_m2 + camera_error_m * camera_error_m;
  Displacement by{to.center - from.center, to.centroid - from.centroid};
  const Eigen::Matrix3f covariance =
      static_cast<float>(scatter.of_center) * CenterCovariance(from, to) +
      static_cast<float>(camera_variance) * Eigen::Matrix3f::Identity();
  by.center_sigmas = std::sqrt(SquaredSigmas(by.of_center, covariance));
  by.centroid_sigmas = by.of_centroid.norm() /
                       std::sqrt(2 * scatter.of_centroid * CentroidVariance(to) + camera_variance);
  return by;
}

void Learn(Scatter& scatter, const Spot& last, const Spot& now) {
  // One jump is not all, and none does not say that there will be none.
  constexpr double kMost = 9, kLeast = 0.05;
  const double of_center = SquaredSigmas(now.center - last.center, CenterCovariance(last, now)) / 3;
  const double of_centroid =
      (now.centroid - last.centroid).squaredNorm() / (6 * CentroidVariance(now));
  scatter.weight = std::min(scatter.weight + 1, Scatter::kLongestWeight);
  const auto mix = [&](double& share, double seen) {
    share += (std::min(seen, kMost) - share) / scatter.weight;
    share = std::max(share, kLeast);
  };
  mix(scatter.of_center, of_center);
  mix(scatter.of_centroid, of_centroid);
}

}  // namespace fovea
