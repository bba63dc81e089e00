// What solid an object is, and how sure that is.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/shape/outline.h"
#include "core/shape/solid_fit.h"
#include "core/types/box_uncertainty.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// A level frame: its plane carries the object. Columns of `rotation` are its axes in the camera
// frame; the third is up.
struct LevelFrame {
  Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();

  Eigen::Vector3f FromCamera(const Eigen::Vector3f& p) const {
    return rotation.transpose() * (p - origin);
  }
  Eigen::Vector3f ToCamera(const Eigen::Vector3f& p) const { return origin + rotation * p; }
};

// That of a box, whose footprint is centred on its origin, with its axes.
LevelFrame FrameUnder(const OrientedBox& box);

// Whether enough points lie below its rim.
bool IsHollow(const FittedSolid& fit);

struct FittedShape {
  Shape::Kind kind = Shape::Kind::kOther;
  float confidence = 0;
  FittedSolid fit;  // of kOther: the one that explains most
  Shape::Form form = Shape::Form::kUnknown;
  float cost = 2;   // of the fit, and for being of its kind: what likelier explanations have less of
  // Level frame; of the solid's box, of kOther of the box around what was seen.
  BoxUncertainty uncertainty;
};

// Tries each solid on the points of the object and the rays through its outline, from the box that
// stands around its visible points, and takes the likeliest.
FittedShape FitShape(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
                     const CameraIntrinsics& intrinsics, const LevelFrame& frame);

}  // namespace fovea
