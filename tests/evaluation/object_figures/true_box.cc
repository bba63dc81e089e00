#include "tests/evaluation/object_figures/true_box.h"

#include <algorithm>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/evaluation/grasp_check/body_surface.h"

namespace fovea::evaluation {
namespace {

std::vector<Eigen::Vector3d> HullInWorld(const scenes::Body& body) {
  std::vector<Eigen::Vector3d> points = HullPoints(body.shape);
  for (Eigen::Vector3d& point : points) point = body.world_from_body * point;
  return points;
}

Eigen::Matrix3d UprightAxes(const Eigen::Vector2d& x) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.col(0).head<2>() = x.normalized();
  axes.col(1) = Eigen::Vector3d::UnitZ().cross(axes.col(0));
  return axes;
}

// Around the points, along these axes.
OrientedBox Around(const std::vector<Eigen::Vector3d>& points, const Eigen::Matrix3d& axes) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d along = axes.transpose() * point;
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  }
  OrientedBox box;
  box.center = (axes * (low + high) / 2).cast<float>();
  box.rotation = axes.cast<float>();
  box.size_m = (high - low).cast<float>();
  return box;
}

}  // namespace

OrientedBox TrueBox(const scenes::Body& body) {
  const std::vector<Eigen::Vector3d> points = HullInWorld(body);
  const Eigen::Vector3d& middle = body.world_from_body.translation();
  std::vector<cv::Point2f> footprint;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d from_middle = point - middle;  // floats are too coarse for the world
    footprint.emplace_back(static_cast<float>(from_middle.x()),
                           static_cast<float>(from_middle.y()));
  }
  const double angle = cv::minAreaRect(footprint).angle * std::numbers::pi / 180;
  const Eigen::Vector2d x(std::cos(angle), std::sin(angle));
  const OrientedBox box = Around(points, UprightAxes(x));
  if (box.size_m.x() >= box.size_m.y()) return box;
  return Around(points, UprightAxes({-x.y(), x.x()}));
}

OrientedBox TrueBoxAlong(const scenes::Body& body, const Eigen::Vector3f& x_axis) {
  return Around(HullInWorld(body), UprightAxes(x_axis.head<2>().cast<double>()));
}

OrientedBox InWorld(const OrientedBox& box, const Eigen::Isometry3d& world_from_camera) {
  const Eigen::Isometry3f transform = world_from_camera.cast<float>();
  return {transform * box.center, transform.linear() * box.rotation, box.size_m};
}

double BoxIou(const OrientedBox& truth, const OrientedBox& answer) {
  constexpr int kSamples = 32;
  const double truth_m3 = truth.size_m.prod(), answer_m3 = answer.size_m.prod();
  if (truth_m3 <= 0 || answer_m3 <= 0) return 0;
  const Eigen::Matrix3f turn = answer.rotation.transpose() * truth.rotation;
  const Eigen::Vector3f offset = answer.rotation.transpose() * (truth.center - answer.center);
  const Eigen::Array3f half = answer.size_m.array() / 2;
  int inside = 0;
  Eigen::Array3f share;
  const auto at = [](int i) { return (static_cast<float>(i) + 0.5F) / kSamples - 0.5F; };
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      for (int k = 0; k < kSamples; ++k) {
        share << at(i), at(j), at(k);
        const Eigen::Vector3f p = turn * (share * truth.size_m.array()).matrix() + offset;
        inside += (p.array().abs() <= half).all();
      }
    }
  }
  const double shared_m3 = truth_m3 * inside / (kSamples * kSamples * kSamples);
  return shared_m3 / (truth_m3 + answer_m3 - shared_m3);
}

}  // namespace fovea::evaluation
