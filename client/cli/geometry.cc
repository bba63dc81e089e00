#include "client/cli/geometry.h"

namespace fovea::cli {

cv::Vec3d ToVec(const v1::Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

cv::Matx33d RotationOf(const v1::Quaternion& q) {
  const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
  return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
}

}  // namespace fovea::cli
