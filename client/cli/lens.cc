#include "client/cli/lens.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace fovea::cli {
namespace {

cv::Matx33d MatrixOf(const v1::CameraIntrinsics& k) {
  return {k.fx(), 0, k.cx(), 0, k.fy(), k.cy(), 0, 0, 1};
}

cv::Mat CoefficientsOf(const v1::LensDistortion& distortion) {
  const auto& numbers = distortion.coefficients();
  return cv::Mat(std::vector<double>(numbers.begin(), numbers.end()), true);
}

// As servers see it: without coefficients nothing is distorted.
bool IsDistorted(const v1::CameraIntrinsics& k) { return k.distortion().coefficients_size() > 0; }

bool IsFisheye(const v1::LensDistortion& distortion) {
  return distortion.model() == v1::DISTORTION_MODEL_KANNALA_BRANDT;
}

// As far beyond the image as servers see that rays do not cross.
cv::Rect2d Surroundings(const cv::Size& size) {
  return {-0.25 * size.width, -0.25 * size.height, 1.5 * size.width, 1.5 * size.height};
}

std::vector<cv::Point2d> Bent(const std::vector<cv::Vec3d>& points, const v1::CameraIntrinsics& k) {
  std::vector<cv::Point2d> pixels;
  if (points.empty()) return pixels;
  const cv::Mat coefficients = CoefficientsOf(k.distortion());
  const cv::Vec3d none(0, 0, 0);
  if (!IsFisheye(k.distortion())) {
    cv::projectPoints(points, none, none, MatrixOf(k), coefficients, pixels);
    return pixels;
  }
  std::vector<cv::Point3d> fisheye_points(points.begin(), points.end());
  cv::fisheye::projectPoints(fisheye_points, pixels, none, none, MatrixOf(k), coefficients);
  return pixels;
}

}  // namespace

std::vector<cv::Point2d> PixelsOf(const std::vector<cv::Vec3d>& points,
                                  const v1::CameraIntrinsics& k, const cv::Size& size) {
  std::vector<cv::Point2d> pixels;
  pixels.reserve(points.size());
  for (const cv::Vec3d& p : points) {
    pixels.emplace_back(k.fx() * p[0] / p[2] + k.cx(), k.fy() * p[1] / p[2] + k.cy());
  }
  if (!IsDistorted(k)) return pixels;
  const std::vector<cv::Point2d> bent = Bent(points, k);
  const cv::Rect2d known = Surroundings(size);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (known.contains(pixels[i])) pixels[i] = bent[i];
  }
  return pixels;
}

cv::Mat RaysOf(const v1::CameraIntrinsics& k, const cv::Size& size) {
  cv::Mat rays(size, CV_64FC2);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      rays.at<cv::Vec2d>(y, x) = IsDistorted(k)
                                     ? cv::Vec2d(x, y)
                                     : cv::Vec2d((x - k.cx()) / k.fx(), (y - k.cy()) / k.fy());
    }
  }
  if (!IsDistorted(k) || rays.empty()) return rays;
  const cv::Mat pixels = rays.reshape(2, 1), coefficients = CoefficientsOf(k.distortion());
  cv::Mat straight;
  if (IsFisheye(k.distortion())) {
    cv::fisheye::undistortPoints(pixels, straight, MatrixOf(k), coefficients);
  } else {
    constexpr int kMostSteps = 20;
    constexpr double kNear = 1e-8;
    const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kMostSteps,
                                    kNear);
    cv::undistortPoints(pixels, straight, MatrixOf(k), coefficients, cv::noArray(), cv::noArray(),
                        criteria);
  }
  return straight.reshape(2, size.height);
}

}  // namespace fovea::cli
