#include "tests/evaluation/object_figures/box_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/evaluation/generated/true_class.h"

namespace fovea::evaluation {
namespace {

double YawBetween(const OrientedBox& truth, const OrientedBox& answer) {
  constexpr float kSquare = 1.1F;
  const Eigen::Vector2f a = truth.rotation.col(0).head<2>();
  const Eigen::Vector2f b = answer.rotation.col(0).head<2>();
  const double cross = a.x() * b.y() - a.y() * b.x();
  double yaw_deg = std::atan2(std::abs(cross), std::abs(a.dot(b))) * 180 / std::numbers::pi;
  const bool square = truth.size_m.x() < kSquare * truth.size_m.y();
  return square ? std::min(yaw_deg, 90 - yaw_deg) : yaw_deg;
}

}  // namespace

BoxErrors CompareBoxes(const scenes::Body& body, const OrientedBox& answer) {
  const bool round = IsRoundUpright(body);
  const OrientedBox truth = round ? TrueBoxAlong(body, answer.rotation.col(0)) : TrueBox(body);
  BoxErrors errors;
  errors.size_m = (answer.size_m - truth.size_m).cast<double>();
  errors.center_m = (answer.center - truth.center).norm();
  errors.iou = BoxIou(truth, answer);
  if (!round) errors.yaw_deg = YawBetween(truth, answer);
  return errors;
}

}  // namespace fovea::evaluation
