#include "core/tracking/velocity_filter.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// What hands do: up to about 1 m/s, from rest to that in a third of a second.
constexpr double kSpeed_m_s = 0.5;
constexpr double kAcceleration_m_s2 = 3;
constexpr double kFirstDeviation_m = 0.02;

}  // namespace

VelocityFilter::VelocityFilter(const Eigen::Vector3f& position, const Eigen::Vector3f& velocity)
    : position_(position.cast<double>()),
      velocity_(velocity.cast<double>()),
      position_variance_(kFirstDeviation_m * kFirstDeviation_m),
      velocity_variance_(kSpeed_m_s * kSpeed_m_s) {}

void VelocityFilter::Transform(const Eigen::Isometry3f& to_from_own) {
  position_ = to_from_own.cast<double>() * position_;
  velocity_ = to_from_own.linear().cast<double>() * velocity_;
}

void VelocityFilter::Predict(double seconds) {
  const double t = seconds, q = kAcceleration_m_s2 * kAcceleration_m_s2;
  position_ += t * velocity_;
  position_variance_ += 2 * t * covariance_ + t * t * velocity_variance_ + q * t * t * t * t / 4;
  covariance_ += t * velocity_variance_ + q * t * t * t / 2;
  velocity_variance_ += q * t * t;
}

void VelocityFilter::Update(const Eigen::Vector3f& position, double deviation_m) {
  const double innovation_variance = position_variance_ + deviation_m * deviation_m;
  const double position_gain = position_variance_ / innovation_variance;
  const double velocity_gain = covariance_ / innovation_variance;
  const Eigen::Vector3d innovation = position.cast<double>() - position_;
  position_ += position_gain * innovation;
  velocity_ += velocity_gain * innovation;
  velocity_variance_ -= velocity_gain * covariance_;
  covariance_ *= 1 - position_gain;
  position_variance_ *= 1 - position_gain;
}

double VelocityFilter::deviation_m() const { return std::sqrt(std::max(0.0, position_variance_)); }

}  // namespace fovea
