#include "core/depth/normals.h"

#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "core/types/lanes.h"

namespace fovea {
namespace {

// Weighted sums of the linear fit of 1/z over the windows of the evaluated columns.
struct FitSums {
  Lanes n{}, u{}, v{}, uu{}, uv{}, vv{}, q{}, qu{}, qv{};
};

// Inverse depth with a margin around it, so that windows need no border checks; 0 = none.
cv::Mat PaddedInverseDepth(const cv::Mat& points, int radius, int step) {
  cv::Mat inverse =
      cv::Mat::zeros(points.rows + 2 * radius, points.cols + 2 * radius + kLanes * step, CV_32FC1);
  for (int row = 0; row < points.rows; ++row) {
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    float* out = inverse.ptr<float>(row + radius) + radius;
    for (int col = 0; col < points.cols; ++col)
      out[col] = point[col][2] > 0 ? 1 / point[col][2] : 0;
  }
  return inverse;
}

// The sums over the windows around kLanes centres, `step` apart, the first of which is at `center`;
// `stride` leads from row to row. One column of the window at a time, so that its offset du is
// multiplied in once.
FOVEA_INLINE FitSums SumWindows(const float* center, std::size_t stride, int step, int radius,
                                float max_change) {
  const Lanes at_center = LoadLanes(center, step);
  const Lanes limit = at_center * max_change;
  FitSums sums;
  for (int du = -radius; du <= radius; ++du) {
    FitSums column;
    const float* top = center - static_cast<std::ptrdiff_t>(stride) * radius + du;
    for (int row = 0; row <= 2 * radius; ++row) {
      const auto dv = static_cast<float>(row - radius);
      // Relative to the centre, which keeps precision.
      const Lanes difference = LoadLanes(top + stride * row, step) - at_center;
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
  std::array<float, kLanes> a, b, c;
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
  PlaneFit fit;
  StoreLanes(a, fit.a.data());
  StoreLanes(b, fit.b.data());
  StoreLanes(at_center + (s.q - a * s.u - b * s.v) / n, fit.c.data());
  return fit;
}

// 1/z = n·ray / d with ray = ((u - cx) / fx, (v - cy) / fy, 1); (du0, dv0) is the pixel relative
// to the principal point.
cv::Vec3f NormalOf(float a, float b, float c, float du0, float dv0, const cv::Vec3f& point,
                   const CameraIntrinsics& k) {
  cv::Vec3f normal(a * static_cast<float>(k.fx_px), b * static_cast<float>(k.fy_px),
                   c - a * du0 - b * dv0);
  normal /= static_cast<float>(cv::norm(normal));
  return normal.dot(point) > 0 ? -normal : normal;
}

// The normals of one row.
struct RowFit {
  const cv::Mat& points;
  const cv::Mat& inverse;
  const CameraIntrinsics& intrinsics;
  const NormalOptions& options;
  int step;

  FOVEA_INLINE void Run(int row, cv::Mat& normals) const {
    const int radius = options.window_radius_px;
    const auto dv0 = static_cast<float>(row - intrinsics.cy_px);
    for (int col = 0; col < points.cols; col += kLanes * step) {
      const float* center = inverse.ptr<float>(row + radius) + radius + col;
      const Lanes at_center = LoadLanes(center, step);
      if (LargestLane(at_center) <= 0) continue;
      const PlaneFit fit = Solve(SumWindows(center, inverse.step1(), step, radius,
                                            static_cast<float>(options.max_depth_change)),
                                 at_center);
      for (int lane = 0; lane < kLanes && col + lane * step < points.cols; ++lane) {
        const int pixel = col + lane * step;
        if (center[pixel - col] <= 0 || std::isnan(fit.a[lane])) continue;
        normals.at<cv::Vec3f>(row, pixel) = NormalOf(
            fit.a[lane], fit.b[lane], fit.c[lane], static_cast<float>(pixel - intrinsics.cx_px),
            dv0, points.at<cv::Vec3f>(row, pixel), intrinsics);
      }
    }
  }
};

}  // namespace

cv::Mat EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                        const NormalOptions& options, int step) {
  const cv::Mat inverse = PaddedInverseDepth(points, options.window_radius_px, step);
  cv::Mat normals(points.size(), CV_32FC3,
                  cv::Scalar::all(std::numeric_limits<float>::quiet_NaN()));
  const RowFit fit{points, inverse, intrinsics, options, step};
  RunInWidestRegisters([&] {
    for (int row = 0; row < points.rows; row += step) fit.Run(row, normals);
  });
  return normals;
}

}  // namespace fovea
