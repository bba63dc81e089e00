#include "core/depth/registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/depth/nearest_surface.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kNearest_m = 0.01;     // in front of the colour camera
constexpr double kSteepest = 5.67;      // tangent of 80°
constexpr double kSmallestStep = 0.01;  // of depth, relative, that may part two surfaces
constexpr double kMaxStepsPerPixel = 32;

// From depth pixels to colour pixels.
class Projection {
 public:
  Projection(const CameraIntrinsics& depth, const Eigen::Isometry3d& color_from_depth,
             const CameraIntrinsics& color)
      : translation_(color_from_depth.translation()), color_(color) {
    Eigen::Matrix3d ray_of_pixel;
    ray_of_pixel << 1 / depth.fx_px, 0, -depth.cx_px / depth.fx_px,  //
        0, 1 / depth.fy_px, -depth.cy_px / depth.fy_px,              //
        0, 0, 1;
    direction_ = color_from_depth.linear() * ray_of_pixel;
  }

  // The point at 1/z = `inverse_z` in depth pixel (x, y); it is scaled with 1/z on the way, so
  // that everything is linear. Cannot be seen where it is behind the camera or close to it.
  ImagePoint operator()(double x, double y, double inverse_z) const {
    const Eigen::Vector3d p = direction_.col(0) * x + direction_.col(1) * y + direction_.col(2) +
                              translation_ * inverse_z;
    if (!(p.z() >= kNearest_m * inverse_z)) return {};
    const double scale = 1 / p.z();
    return {color_.fx_px * p.x() * scale + color_.cx_px,
            color_.fy_px * p.y() * scale + color_.cy_px, inverse_z * scale};
  }

 private:
  Eigen::Matrix3d direction_;
  Eigen::Vector3d translation_;
  CameraIntrinsics color_;
};

// A depth pixel.
struct Sample {
  double x = 0, y = 0;
  double inverse_z = 0;  // 0 = none
  ImagePoint in_color;
};

// The square between the centres of four depth pixels.
class Cell {
 public:
  // The corners in order around the square.
  Cell(const std::array<const Sample*, 4>& corners, double depth_ratio) : corners_(corners) {
    for (int i = 0; i < 4; ++i) {
      const double a = At(i).inverse_z, b = At(i + 1).inverse_z;
      // z_far ≤ ratio · z_near, in 1/z.
      joined_[i] = a > 0 && b > 0 && std::max(a, b) <= depth_ratio * std::min(a, b);
    }
  }

  void Draw(const Projection& project, NearestSurface& surface) const {
    if (std::all_of(joined_.begin(), joined_.end(), [](bool joined) { return joined; })) {
      surface.Draw(At(0).in_color, At(1).in_color, At(2).in_color);
      surface.Draw(At(0).in_color, At(2).in_color, At(3).in_color);
      return;
    }
    for (int i = 0; i < 4; ++i) {
      if (At(i).inverse_z > 0) DrawQuarter(i, project, surface);
    }
  }

 private:
  const Sample& At(int i) const { return *corners_[i & 3]; }

  // 1/z in the middle of the side from corner i to the next.
  double Middle(int i, double own) const {
    return joined_[i & 3] ? (At(i).inverse_z + At(i + 1).inverse_z) / 2 : own;
  }

  // Mean 1/z of the corners that belong to the surface of corner i.
  double Center(int i) const {
    double sum = At(i).inverse_z;
    int count = 1;
    for (int j = i; joined_[j & 3]; ++j, ++count) sum += At(j + 1).inverse_z;
    for (int j = i - 1; joined_[j & 3]; --j, ++count) sum += At(j).inverse_z;
    return sum / count;
  }

  // The part that is nearest to corner i. What two joined corners draw meets without a gap.
  void DrawQuarter(int i, const Projection& project, NearestSurface& surface) const {
    const Sample& own = At(i);
    const auto towards = [&](const Sample& other, double inverse_z) {
      return project((own.x + other.x) / 2, (own.y + other.y) / 2, inverse_z);
    };
    const ImagePoint center = towards(At(i + 2), Center(i));
    surface.Draw(own.in_color, towards(At(i + 1), Middle(i, own.inverse_z)), center);
    surface.Draw(own.in_color, center, towards(At(i + 3), Middle(i + 3, own.inverse_z)));
  }

  std::array<const Sample*, 4> corners_;
  std::array<bool, 4> joined_{};  // whether corner i and the next are of one surface
};

// The samples of a row, with one that has no depth on either side; without any depth for rows
// outside of the image.
std::vector<Sample> SamplesOfRow(const cv::Mat& depth_m, int row, const Projection& project) {
  std::vector<Sample> samples(depth_m.cols + 2);
  const bool inside = row >= 0 && row < depth_m.rows;
  for (int i = 0; i < depth_m.cols + 2; ++i) {
    Sample& sample = samples[i];
    sample.x = i - 1;
    sample.y = row;
    if (!inside || i == 0 || i == depth_m.cols + 1) continue;
    const float z = depth_m.at<float>(row, i - 1);
    if (!(std::isfinite(z) && z > 0)) continue;
    sample.inverse_z = 1.0 / z;
    sample.in_color = project(sample.x, sample.y, sample.inverse_z);
  }
  return samples;
}

// The largest ratio of the depths of two neighbours on one surface.
double DepthRatio(const CameraIntrinsics& depth) {
  return 1 + std::max(kSmallestStep, kSteepest / std::min(depth.fx_px, depth.fy_px));
}

}  // namespace

cv::Mat RegisterDepth(const cv::Mat& depth_m, const CameraIntrinsics& depth_intrinsics,
                      const Eigen::Isometry3d& color_from_depth,
                      const CameraIntrinsics& color_intrinsics, const cv::Size& color_size) {
  if (depth_m.empty() || color_size.empty()) throw std::invalid_argument("the image is empty");
  if (depth_m.type() != CV_32FC1) throw std::invalid_argument("depth must be 32-bit float");
  const Projection project(depth_intrinsics, color_from_depth, color_intrinsics);
  const double depth_ratio = DepthRatio(depth_intrinsics);
  const double num_pixels = double(depth_m.total()) + double(color_size.area());
  NearestSurface surface(color_size, kMaxStepsPerPixel * num_pixels);

  std::vector<Sample> above = SamplesOfRow(depth_m, -1, project);
  for (int row = 0; row <= depth_m.rows; ++row) {
    InterruptionPoint();
    std::vector<Sample> below = SamplesOfRow(depth_m, row, project);
    for (int i = 0; i <= depth_m.cols; ++i) {
      Cell({&above[i], &above[i + 1], &below[i + 1], &below[i]}, depth_ratio)
          .Draw(project, surface);
    }
    above = std::move(below);
  }
  return surface.Depth();
}

}  // namespace fovea
