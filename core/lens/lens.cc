#include "core/lens/lens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace fovea {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Lens::Lens(const CameraIntrinsics& intrinsics, const LensDistortion& distortion,
           const cv::Size& size)
    : k_(intrinsics), distortion_(distortion), size_(size) {
  for (const double value : distortion.coefficients) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument(fmt::format("{:g} is not a finite number", value));
    }
  }
  const double tangential =
      std::max(std::abs(distortion.coefficients[2]), std::abs(distortion.coefficients[3]));
  if (distortion.model == LensDistortion::Model::kBrownConrady && tangential > 1) {
    throw std::invalid_argument(
        fmt::format("{:g} is no tangential coefficient of a lens: p1 and p2 are the third and "
                    "fourth, and lie within -1 and 1",
                    tangential));
  }
  if (std::max(size.width, size.height) > kLongestSide_px) {
    throw std::invalid_argument(
        fmt::format("an image of {}x{} pixels is not undistorted: a side has at most {}",
                    size.width, size.height, kLongestSide_px));
  }
  largest_radius_ = LargestRadius();
}

// Walks from the axis to the farthest corner, while what is farther out stays farther out.
double Lens::LargestRadius() const {
  constexpr int kSteps = 500, kStepsBetweenLooks = 10;
  // Slower than this, a pixel sees what a dozen should.
  constexpr double kSlowest = 0.08;
  // Faster than this, it sees a dozenth of one.
  constexpr double kFastest = 12;
  double corner = 0;
  for (const double x : {-0.5, size_.width - 0.5}) {
    for (const double y : {-0.5, size_.height - 0.5}) {
      corner = std::max(corner, cv::norm(RayOf({x, y})));
    }
  }
  const double step = corner / kSteps;
  double last = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double next = BendRadius(i * step), farther = next - last;
    const double slowest = kSlowest * step / (1 + i * step * i * step);  // of a fisheye, too
    // The tangential terms change slowly.
    const bool crosses = i % kStepsBetweenLooks == 0 && CrossesAt(i * step);
    if (crosses || !(farther > slowest && farther < kFastest * step)) {
      if (2 * i < kSteps) {
        throw std::invalid_argument(fmt::format(
            "these send rays back or apart from {:.0f} px beside the optical axis on, where the "
            "image reaches to {:.0f} px: they are of another model, order or image size",
            i * step * k_.fx_px, corner * k_.fx_px));
      }
      return (i - 1) * step;
    }
    last = next;
  }
  return corner;
}

double Lens::BendRadius(double radius) const {
  const auto& k = distortion_.coefficients;
  if (distortion_.model == LensDistortion::Model::kKannalaBrandt) {
    const double angle = std::atan(radius), a = angle * angle;
    return angle * (1 + a * (k[0] + a * (k[1] + a * (k[2] + a * k[3]))));
  }
  const double r = radius * radius;
  return radius * (1 + r * (k[0] + r * (k[1] + r * k[4]))) /
         (1 + r * (k[5] + r * (k[6] + r * k[7])));
}

cv::Point2d Lens::Bend(const cv::Point2d& ray) const {
  const double x = ray.x, y = ray.y, square = x * x + y * y, radius = std::sqrt(square);
  const double factor = radius > 1e-9 ? BendRadius(radius) / radius : 1;
  cv::Point2d bent = ray * factor;
  if (distortion_.model == LensDistortion::Model::kBrownConrady) {
    const double p1 = distortion_.coefficients[2], p2 = distortion_.coefficients[3];
    bent.x += 2 * p1 * x * y + p2 * (square + 2 * x * x);
    bent.y += p1 * (square + 2 * y * y) + 2 * p2 * x * y;
  }
  return bent;
}

Lens::Slopes Lens::SlopesAt(const cv::Point2d& ray, const cv::Point2d& bent) const {
  constexpr double kDelta = 1e-6;
  return {(Bend({ray.x + kDelta, ray.y}) - bent) / kDelta,
          (Bend({ray.x, ray.y + kDelta}) - bent) / kDelta};
}

bool Lens::CrossesAt(double radius) const {
  if (distortion_.model != LensDistortion::Model::kBrownConrady) return false;
  constexpr int kDirections = 16;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = i * 2 * std::numbers::pi / kDirections;
    const cv::Point2d ray = radius * cv::Point2d(std::cos(angle), std::sin(angle));
    if (!(SlopesAt(ray, Bend(ray)).Determinant() > 0)) return true;
  }
  return false;
}

cv::Point2d Lens::RayOf(const cv::Point2d& pixel) const {
  return {(pixel.x - k_.cx_px) / k_.fx_px, (pixel.y - k_.cy_px) / k_.fy_px};
}

cv::Point2d Lens::PixelOf(const cv::Point2d& ray) const {
  return {ray.x * k_.fx_px + k_.cx_px, ray.y * k_.fy_px + k_.cy_px};
}

bool Lens::IsShown(const cv::Point2d& ideal) const {
  return cv::norm(RayOf(ideal)) <= largest_radius_;
}

cv::Point2d Lens::Distort(const cv::Point2d& ideal) const {
  const cv::Point2d ray = RayOf(ideal);
  const double radius = cv::norm(ray);
  return PixelOf(Bend(radius > largest_radius_ ? ray * (largest_radius_ / radius) : ray));
}

cv::Point2d Lens::Undistort(const cv::Point2d& sent, const cv::Point2d& start) const {
  constexpr int kMaxSteps = 20;
  constexpr double kClose_px = 0.01;
  const cv::Point2d wanted = RayOf(sent);
  const double close = kClose_px / std::max(k_.fx_px, k_.fy_px);
  cv::Point2d ray = RayOf(start);
  for (int step = 0; step < kMaxSteps; ++step) {
    const double radius = cv::norm(ray);
    if (!(radius < 2 * largest_radius_)) break;
    if (radius > largest_radius_) ray *= largest_radius_ / radius;
    const cv::Point2d bent = Bend(ray), missing = wanted - bent;
    if (cv::norm(missing) < close) return PixelOf(ray);
    const Slopes slopes = SlopesAt(ray, bent);
    ray += cv::Point2d(missing.cross(slopes.y), slopes.x.cross(missing)) / slopes.Determinant();
  }
  return {kNan, kNan};
}

}  // namespace fovea
