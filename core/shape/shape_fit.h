// What solid an object is, and how sure that is.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/shape/level_frame.h"
#include "core/shape/outline.h"
#include "core/shape/solid_fit.h"
#include "core/types/box_uncertainty.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Whether enough points lie below its rim.
bool IsHollow(const FittedSolid& fit);

struct FittedShape {
  Shape::Kind kind = Shape::Kind::kOther;
  float confidence = 0;
  FittedSolid fit;  // of kOther: the one that explains most
  Shape::Form form = Shape::Form::kUnknown;
  float cost = 2;  // of the fit, and for being of its kind: what likelier explanations have less of
  // Level frame; of the solid's box, of kOther of the box around what was seen.
  BoxUncertainty uncertainty;
};

// Tries each solid on the points of the object and the rays through its outline, from the box that
// stands around its visible points, and takes the likeliest.
FittedShape FitShape(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
                     const CameraIntrinsics& intrinsics, const LevelFrame& frame);

}  // namespace fovea
