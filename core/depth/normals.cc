#include "core/depth/normals.h"

#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core/hal/intrin.hpp>

namespace fovea {
namespace {

using Four = cv::v_float32x4;
constexpr int kLanes = 4;

// Weighted sums of the linear fit of 1/z over the windows of four evaluated columns.
struct FitSums {
  Four n = cv::v_setzero_f32(), u = n, v = n, uu = n, uv = n, vv = n, q = n, qu = n, qv = n;
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

Four Load(const float* first, std::ptrdiff_t step) {
  return step == 1 ? cv::v_load(first)
                   : Four(first[0], first[step], first[2 * step], first[3 * step]);
}

// The sums over the windows around four centres, `step` apart, the first of which is at `center`;
// `stride` leads from row to row. One column of the window at a time, so that its offset du is
// multiplied in once.
FitSums SumWindows(const float* center, std::size_t stride, int step, int radius,
                   float max_change) {
  const Four at_center = Load(center, step);
  const Four limit = at_center * cv::v_setall_f32(max_change);
  const Four one = cv::v_setall_f32(1);
  FitSums sums;
  for (int du = -radius; du <= radius; ++du) {
    FitSums column;
    const float* top = center - static_cast<std::ptrdiff_t>(stride) * radius + du;
    for (int row = 0; row <= 2 * radius; ++row) {
      const Four dv = cv::v_setall_f32(static_cast<float>(row - radius));
      // Relative to the centre, which keeps precision.
      const Four difference = Load(top + stride * row, step) - at_center;
      const Four same_surface = cv::v_abs(difference) <= limit;
      const Four weight = same_surface & one;
      const Four value = same_surface & difference;
      column.n += weight;
      column.v += weight * dv;
      column.vv += weight * dv * dv;
      column.q += value;
      column.qv += value * dv;
    }
    const Four offset = cv::v_setall_f32(static_cast<float>(du));
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

PlaneFit Solve(const FitSums& s, const Four& at_center) {
  const Four n = cv::v_max(s.n, cv::v_setall_f32(1));
  // Normal equations of the centred fit.
  const Four uu = s.uu - s.u * s.u / n;
  const Four uv = s.uv - s.u * s.v / n;
  const Four vv = s.vv - s.v * s.v / n;
  const Four qu = s.qu - s.q * s.u / n;
  const Four qv = s.qv - s.q * s.v / n;
  const Four determinant = uu * vv - uv * uv;
  const Four on_a_line = determinant < cv::v_setall_f32(1e-3F);
  const Four none = cv::v_setall_f32(std::numeric_limits<float>::quiet_NaN());
  const Four a = cv::v_select(on_a_line, none, (qu * vv - qv * uv) / determinant);
  const Four b = (qv * uu - qu * uv) / determinant;
  const Four c = at_center + (s.q - a * s.u - b * s.v) / n;
  PlaneFit fit;
  cv::v_store(fit.a.data(), a);
  cv::v_store(fit.b.data(), b);
  cv::v_store(fit.c.data(), c);
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

}  // namespace

cv::Mat EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                        const NormalOptions& options, int step) {
  const int radius = options.window_radius_px;
  const cv::Mat inverse = PaddedInverseDepth(points, radius, step);
  const std::size_t stride = inverse.step1();
  cv::Mat normals(points.size(), CV_32FC3,
                  cv::Scalar::all(std::numeric_limits<float>::quiet_NaN()));

  for (int row = 0; row < points.rows; row += step) {
    const float dv0 = static_cast<float>(row - intrinsics.cy_px);
    for (int col = 0; col < points.cols; col += kLanes * step) {
      const float* center = inverse.ptr<float>(row + radius) + radius + col;
      const Four at_center = Load(center, step);
      if (!cv::v_check_any(at_center > cv::v_setzero_f32())) continue;
      const PlaneFit fit = Solve(
          SumWindows(center, stride, step, radius, static_cast<float>(options.max_depth_change)),
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
  return normals;
}

}  // namespace fovea
