// The contract's geometry as OpenCV's.
#pragma once

#include <opencv2/core/matx.hpp>

#include "fovea/v1/geometry.pb.h"

namespace fovea::cli {

cv::Vec3d ToVec(const v1::Vector3& vector);

// Of a unit quaternion.
cv::Matx33d RotationOf(const v1::Quaternion& quaternion);

}  // namespace fovea::cli
