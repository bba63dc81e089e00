// A Kalman filter of a point that moves (Kalman 1960), by the model of constant velocity.
#pragma once

#include <Eigen/Geometry>

namespace fovea {

// All axes have the same noise, so that one 2×2 covariance serves the three of them.
class VelocityFilter {
 public:
  // `velocity` in m/s with a standard deviation of kSpeed_m_s.
  VelocityFilter(const Eigen::Vector3f& position, const Eigen::Vector3f& velocity);

  // The frame of reference changes.
  void Transform(const Eigen::Isometry3f& to_from_own);
  // `seconds`, 0 or more, pass.
  void Predict(double seconds);
  // It stands, as far as is known.
  void Stop() { velocity_.setZero(); }
  // The position was measured with this standard deviation, more than 0.
  void Update(const Eigen::Vector3f& position, double deviation_m);

  Eigen::Vector3f position() const { return position_.cast<float>(); }
  Eigen::Vector3f velocity() const { return velocity_.cast<float>(); }  // m/s
  double deviation_m() const;                                           // of the position

 private:
  Eigen::Vector3d position_, velocity_;
  double position_variance_, covariance_ = 0, velocity_variance_;
};

}  // namespace fovea
