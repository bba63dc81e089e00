#include "core/depth/normals.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/interruption.h"
#include "core/types/lanes.h"

namespace fovea {
namespace {

// Weighted sums of the linear fit of 1/z over the windows of the evaluated columns.
struct FitSums {
  Lanes n{}, u{}, v{}, uu{}, uv{}, vv{}, q{}, qu{}, qv{};
};

// Inverse depth with a margin around it, so that windows need no border checks; 0 = none. In each
// row every step-th column comes first, then their right neighbours, and so on: so the pixels at
// one place of the windows around centres `step` apart are neighbours.
class InverseDepth {
 public:
  // Pixels that no window samples stay 0.
  InverseDepth(const cv::Mat& points, const NormalOptions& options)
      : radius_(options.window_radius_px),
        step_(options.step_px),
        centers_((points.cols + 2 * radius_) / step_ + kLanes),
        image_(cv::Mat::zeros(points.rows + 2 * radius_, centers_ * step_, CV_32FC1)) {
    const int lattice = std::gcd(step_, options.sample_px);
    for (int row = 0; row < points.rows; row += lattice) {
      InterruptionPoint();
      const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
      for (int first = 0; first < step_; first += lattice) {
        float* out = image_.ptr<float>(row + radius_) + Place(first);
        for (int col = first; col < points.cols; col += step_) {
          *out++ = point[col][2] > 0 ? 1 / point[col][2] : 0;
        }
      }
    }
  }

  // Of a pixel, followed by those `step`, 2 · step, … to the right of it; up to the window's radius
  // outside of the image.
  const float* At(int row, int col) const { return image_.ptr<float>(row + radius_) + Place(col); }
  std::ptrdiff_t RowStride() const { return static_cast<std::ptrdiff_t>(image_.step1()); }

 private:
  int Place(int col) const { return (col + radius_) % step_ * centers_ + (col + radius_) / step_; }

  int radius_, step_;
  int centers_;  // columns that share a remainder by `step`
  cv::Mat image_;
};

// The sums over the windows around the centres at `row` and col, col + step, …
FOVEA_INLINE FitSums SumWindows(const InverseDepth& inverse, int row, int col,
                                const NormalOptions& options) {
  const Lanes at_center = LoadLanes(inverse.At(row, col));
  const Lanes limit = at_center * static_cast<float>(options.max_depth_change);
  const int sample = options.sample_px;
  const int reach = options.window_radius_px / sample * sample;
  const std::ptrdiff_t stride = inverse.RowStride() * sample;
  FitSums sums;
  // One column of the window at a time, so that its offset du is multiplied in once.
  for (int du = -reach; du <= reach; du += sample) {
    FitSums column;
    const float* place = inverse.At(row - reach, col + du);
    for (int dv_px = -reach; dv_px <= reach; dv_px += sample, place += stride) {
      const auto dv = static_cast<float>(dv_px);
      // Relative to the centre, which keeps precision.
      const Lanes difference = LoadLanes(place) - at_center;
      const auto same_surface = Magnitude(difference) <= limit;
      const Lanes weight = same_surface ? AllLanes(1) : Lanes{};
      const Lanes value = same_surface ? difference : Lanes{};
      column.n += weight;
      column.v += weight * dv;
      column.vv += weight * dv * dv;
      column.q += value;
      column.qv += value * dv;
    }
    const auto offset = static_cast<float>(du);
    sums.n += column.n;
    sums.u += column.n * offset;
    sums.uu += column.n * offset * offset;
    sums.v += column.v;
    sums.uv += column.v * offset;
    sums.vv += column.vv;
    sums.q += column.q;
    sums.qu += column.q * offset;
    sums.qv += column.qv;
  }
  return sums;
}

// 1/z = a·u + b·v + c around each centre; `a` is not a number where the window fits no plane.
struct PlaneFit {
  Lanes a, b, c;
};

FOVEA_INLINE PlaneFit Solve(const FitSums& s, const Lanes& at_center) {
  const Lanes n = Larger(s.n, AllLanes(1));
  // Normal equations of the centred fit.
  const Lanes uu = s.uu - s.u * s.u / n;
  const Lanes uv = s.uv - s.u * s.v / n;
  const Lanes vv = s.vv - s.v * s.v / n;
  const Lanes qu = s.qu - s.q * s.u / n;
  const Lanes qv = s.qv - s.q * s.v / n;
  const Lanes determinant = uu * vv - uv * uv;
  const Lanes none = AllLanes(std::numeric_limits<float>::quiet_NaN());
  const Lanes a = determinant < 1e-3F ? none : (qu * vv - qv * uv) / determinant;  // on a line
  const Lanes b = (qv * uu - qu * uv) / determinant;
  return {a, b, at_center + (s.q - a * s.u - b * s.v) / n};
}

// Vectors, one a lane.
struct Vectors {
  std::array<float, kLanes> x, y, z;
};

// 1/z = n·ray / d with ray = ((u - cx) / fx, (v - cy) / fy, 1); (du0, dv0) is the pixel relative
// to the principal point.
FOVEA_INLINE Vectors NormalsOf(const PlaneFit& fit, const Lanes& du0, float dv0,
                               const CameraIntrinsics& k) {
  const Lanes x = fit.a * static_cast<float>(k.fx_px);
  const Lanes y = fit.b * static_cast<float>(k.fy_px);
  const Lanes z = fit.c - fit.a * du0 - fit.b * dv0;
  Vectors normals;
  StoreLanes(x, normals.x.data());
  StoreLanes(y, normals.y.data());
  StoreLanes(z, normals.z.data());
  std::array<float, kLanes> inverse_lengths;
  for (int lane = 0; lane < kLanes; ++lane) {
    const double nx = normals.x[lane], ny = normals.y[lane], nz = normals.z[lane];
    inverse_lengths[lane] = 1 / static_cast<float>(std::sqrt(nx * nx + ny * ny + nz * nz));
  }
  const Lanes scale = LoadLanes(inverse_lengths.data());
  StoreLanes(x * scale, normals.x.data());
  StoreLanes(y * scale, normals.y.data());
  StoreLanes(z * scale, normals.z.data());
  return normals;
}

cv::Vec3f TowardsCamera(const cv::Vec3f& normal, const cv::Vec3f& point) {
  return normal.dot(point) > 0 ? -normal : normal;
}

// Every step-th column relative to the principal point, and as many more as a load may reach.
std::vector<float> RelativeColumns(int cols, int step, double cx_px) {
  std::vector<float> relative;
  for (int col = 0; col < cols + kLanes * step; col += step) {
    relative.push_back(static_cast<float>(col - cx_px));
  }
  return relative;
}

// The normals of one row.
struct RowFit {
  const cv::Mat& points;
  const InverseDepth& inverse;
  const std::vector<float>& relative_cols;
  const CameraIntrinsics& intrinsics;
  const NormalOptions& options;

  FOVEA_INLINE void Run(int row, cv::Mat& normals) const {
    const int step = options.step_px;
    const auto dv0 = static_cast<float>(row - intrinsics.cy_px);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row / step);
    for (int first = 0; first < points.cols; first += kLanes * step) {
      const Lanes at_center = LoadLanes(inverse.At(row, first));
      if (LargestLane(at_center) <= 0) continue;
      const PlaneFit fit = Solve(SumWindows(inverse, row, first, options), at_center);
      const Vectors n =
          NormalsOf(fit, LoadLanes(relative_cols.data() + first / step), dv0, intrinsics);
      for (int lane = 0; lane < kLanes && first + lane * step < points.cols; ++lane) {
        if (at_center[lane] <= 0 || std::isnan(fit.a[lane])) continue;
        normal[first / step + lane] =
            TowardsCamera({n.x[lane], n.y[lane], n.z[lane]}, point[first + lane * step]);
      }
    }
  }
};

}  // namespace

NormalMap EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                          const NormalOptions& options) {
  const InverseDepth inverse(points, options);
  const int step = options.step_px;
  cv::Mat normals((points.rows + step - 1) / step, (points.cols + step - 1) / step, CV_32FC3,
                  cv::Scalar::all(std::numeric_limits<float>::quiet_NaN()));
  const std::vector<float> relative_cols = RelativeColumns(points.cols, step, intrinsics.cx_px);
  const RowFit fit{points, inverse, relative_cols, intrinsics, options};
  RunInWidestRegisters([&] {
    for (int row = 0; row < points.rows; row += step) {
      InterruptionPoint();
      fit.Run(row, normals);
    }
  });
  return {normals, step};
}

}  // namespace fovea
