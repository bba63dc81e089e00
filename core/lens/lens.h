// A lens that bends rays away from the pinhole model, as cameras are calibrated.
#pragma once

#include <array>
#include <opencv2/core/types.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// Named and ordered as in OpenCV. With r² = x² + y² of the ideal ray (x, y, 1):
struct LensDistortion {
  enum class Model {
    // k1, k2, p1, p2, k3, k4, k5, k6; ROS's "plumb_bob" (the last three 0) and
    // "rational_polynomial":
    //   f = (1 + k1 r² + k2 r⁴ + k3 r⁶) / (1 + k4 r² + k5 r⁴ + k6 r⁶)
    //   x' = f x + 2 p1 x y + p2 (r² + 2 x²),  y' = f y + p1 (r² + 2 y²) + 2 p2 x y
    kBrownConrady,
    // k1, k2, k3, k4; ROS's "equidistant", OpenCV's fisheye. With θ = atan r:
    //   x' = x θ / r · (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸), y' alike
    kKannalaBrandt
  };
  Model model = Model::kBrownConrady;
  std::array<double, 8> coefficients{};
};

// From pixels of the image that the camera sends to those of an ideal one and back: a pinhole
// camera of the same intrinsics and image size in its place, whose axes are the same.
class Lens {
 public:
  static constexpr int kLongestSide_px = 32766;  // cv::remap's

  // Throws std::invalid_argument, which says what is wrong with the coefficients: not finite, or
  // such that rays come back, cross or part within half of the way to the farthest corner; or where
  // a side of the image is longer than kLongestSide_px.
  Lens(const CameraIntrinsics& intrinsics, const LensDistortion& distortion, const cv::Size& size);

  // Where the camera shows what is at this pixel of the ideal image. Beyond where rays would come
  // back nothing is shown: the answer is the last place before that.
  cv::Point2d Distort(const cv::Point2d& ideal) const;
  bool IsShown(const cv::Point2d& ideal) const;

  // Its inverse, within 0.01 pixels; NaN where no ray of the ideal image meets the pixel. Newton's
  // method from `start`, which is best near the answer, such as that of a neighbour: some 0.2 µs.
  cv::Point2d Undistort(const cv::Point2d& sent, const cv::Point2d& start) const;
  cv::Point2d Undistort(const cv::Point2d& sent) const { return Undistort(sent, sent); }

  const cv::Size& size() const { return size_; }

 private:
  cv::Point2d Bend(const cv::Point2d& ray) const;  // (x, y) → (x', y')
  double BendRadius(double radius) const;          // without p1 and p2
  // The derivatives of Bend along x and along y.
  struct Slopes {
    cv::Point2d x, y;
    double Determinant() const { return x.cross(y); }
  };
  Slopes SlopesAt(const cv::Point2d& ray, const cv::Point2d& bent) const;  // bent = Bend(ray)
  bool CrossesAt(double radius) const;  // whether rays do, in any direction
  cv::Point2d RayOf(const cv::Point2d& pixel) const;
  cv::Point2d PixelOf(const cv::Point2d& ray) const;
  double LargestRadius() const;

  CameraIntrinsics k_;
  LensDistortion distortion_;
  cv::Size size_;
  double largest_radius_ = 0;  // of rays that do not cross
};

}  // namespace fovea
