#include "core/shape/completed.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/shape/surface_samples.h"

namespace fovea {
namespace {

OrientedBox BoxOf(const Solid& solid, const LevelFrame& frame) {
  Eigen::Vector3f size = solid.Size();
  Eigen::Vector3f along(solid.along.x(), solid.along.y(), 0);
  if (size.y() > size.x()) {
    std::swap(size.x(), size.y());
    along = Eigen::Vector3f(-along.y(), along.x(), 0);
  }
  OrientedBox box;
  box.size_m = size;
  box.center = frame.ToCamera({solid.center.x(), solid.center.y(), size.z() / 2});
  box.rotation.col(0) = (frame.rotation * along).normalized();
  box.rotation.col(2) = frame.rotation.col(2);
  box.rotation.col(1) = box.rotation.col(2).cross(box.rotation.col(0));
  return box;
}

// Level and away from the camera.
Eigen::Vector2f AwayFromCamera(const LevelFrame& frame, const Eigen::Vector2f& center) {
  const Eigen::Vector3f camera = frame.FromCamera(Eigen::Vector3f::Zero());
  const Eigen::Vector2f away = center - camera.head<2>();
  return away.norm() > 1e-3F ? Eigen::Vector2f(away.normalized()) : Eigen::Vector2f::UnitX();
}

bool Lies(const Solid& solid) {
  return solid.kind == Solid::Kind::kLyingCylinder || solid.kind == Solid::Kind::kBent;
}

bool IsRoundAboutUpright(Shape::Kind kind, const Solid& solid) {
  return kind == Shape::Kind::kSphere || kind == Shape::Kind::kRevolution ||
         (kind == Shape::Kind::kCylinder && !Lies(solid));
}

void SetRoundShape(const Solid& solid, const LevelFrame& frame, Shape& shape) {
  const Eigen::Vector3f size = solid.Size();
  shape.center = frame.ToCamera({solid.center.x(), solid.center.y(), size.z() / 2});
  const bool lies = Lies(solid);
  const Eigen::Vector3f axis =
      lies ? Eigen::Vector3f(solid.along.x(), solid.along.y(), 0) : Eigen::Vector3f::UnitZ().eval();
  shape.radius_m = solid.WidestRadius();
  if (solid.kind == Solid::Kind::kSphere) return;
  shape.axis = frame.rotation * axis;
  shape.length_m = lies ? size.x() : size.z();
}

// Taken from the level frame to the camera's, and to the axes of the box where these are swapped.
BoxUncertainty InCamera(const BoxUncertainty& level, const LevelFrame& frame, bool is_swapped) {
  Eigen::Matrix4f turn = Eigen::Matrix4f::Identity();
  turn.topLeftCorner<3, 3>() = frame.rotation;
  BoxUncertainty uncertainty = level;
  const Eigen::Matrix4f turned = turn * level.pose_covariance * turn.transpose();
  uncertainty.pose_covariance = (turned + turned.transpose()) / 2;  // but for rounding it is that
  if (is_swapped) std::swap(uncertainty.size_sigma_m.x(), uncertainty.size_sigma_m.y());
  return uncertainty;
}

}  // namespace

void SetShape(const FittedShape& fitted, const LevelFrame& frame, DetectedObject& object) {
  Solid solid = fitted.fit.solid;
  object.yaw_is_arbitrary = false;
  Shape& shape = object.shape = {};
  shape.kind = fitted.kind;
  shape.confidence = fitted.confidence;
  shape.residual_m = fitted.fit.residual_m;
  const Eigen::Vector3f size = solid.Size();
  shape.form = fitted.form;
  const bool is_other = fitted.kind == Shape::Kind::kOther && fitted.form == Shape::Form::kUnknown;
  object.uncertainty = InCamera(fitted.uncertainty, frame, !is_other && size.y() > size.x());
  if (is_other) {
    const float top = (object.visible_box.center - frame.origin).dot(frame.rotation.col(2)) +
                      object.visible_box.size_m.z() / 2;
    object.box = object.visible_box;
    object.box.size_m.z() = std::max(top, object.visible_box.size_m.z());
    object.box.center +=
        frame.rotation.col(2) * ((object.visible_box.size_m.z() - object.box.size_m.z()) / 2);
    return;
  }
  object.yaw_is_arbitrary = IsRoundAboutUpright(fitted.kind, solid);
  if (object.yaw_is_arbitrary) solid.along = AwayFromCamera(frame, solid.center);
  object.box = BoxOf(solid, frame);
  if (shape.form == Shape::Form::kBent) shape.bend_m = solid.bend_m;
  const bool is_round = solid.kind != Solid::Kind::kBox && fitted.kind != Shape::Kind::kOther;
  if (is_round) SetRoundShape(solid, frame, shape);
  if (fitted.kind == Shape::Kind::kRevolution) {
    shape.hollow = IsHollow(fitted.fit);
    constexpr int kRadii = 8;
    for (int i = 0; i < kRadii; ++i) {
      shape.radii_m.push_back(solid.RadiusAt((static_cast<float>(i) + 0.5F) / kRadii));
    }
  }
}

void SetUnseenShare(const cv::Mat& labels, const CameraIntrinsics& intrinsics,
                    const FittedShape& fitted, const LevelFrame& frame, DetectedObject& object) {
  const cv::Rect image({}, labels.size());
  float seen = 0, all = 0;
  for (const SurfaceSample& sample : SampleSurface(fitted.fit.solid)) {
    const Eigen::Vector3f at = frame.ToCamera(sample.position);
    all += sample.area_m2;
    if (at.z() <= 0 || (frame.rotation * sample.normal).dot(at) >= 0) continue;
    const cv::Point pixel(cvRound(at.x() / at.z() * intrinsics.fx_px + intrinsics.cx_px),
                          cvRound(at.y() / at.z() * intrinsics.fy_px + intrinsics.cy_px));
    if (image.contains(pixel) && labels.at<std::uint16_t>(pixel) == object.label) {
      seen += sample.area_m2;
    }
  }
  object.unseen_share = all > 0 ? 1 - seen / all : 1;
}

}  // namespace fovea
