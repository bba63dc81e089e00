#include "core/depth/normals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fovea {
namespace {

// Weighted sums of the linear fit of 1/z over one window, one entry per evaluated column. Kept as
// separate arrays so that the compiler vectorises the accumulation.
struct FitSums {
  explicit FitSums(int size)
      : n(size), u(size), v(size), uu(size), uv(size), vv(size), q(size), qu(size), qv(size) {}
  void Reset() {
    for (auto* sum : {&n, &u, &v, &uu, &uv, &vv, &q, &qu, &qv}) {
      std::fill(sum->begin(), sum->end(), 0.0F);
    }
  }
  std::vector<float> n, u, v, uu, uv, vv, q, qu, qv;
};

// Inverse depth with a margin around it, so that windows need no border checks; 0 = none.
cv::Mat PaddedInverseDepth(const cv::Mat& points, int radius) {
  cv::Mat inverse = cv::Mat::zeros(points.rows + 2 * radius, points.cols + 2 * radius, CV_32FC1);
  for (int row = 0; row < points.rows; ++row) {
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    float* out = inverse.ptr<float>(row + radius) + radius;
    for (int col = 0; col < points.cols; ++col)
      out[col] = point[col][2] > 0 ? 1 / point[col][2] : 0;
  }
  return inverse;
}

// Adds the window pixel at offset (du, dv) of every evaluated column to its sums. `center` and
// `neighbor` are inverse depths; `max_change` is relative.
void AccumulateOffset(const float* center, const float* neighbor, int count, float du, float dv,
                      float max_change, FitSums& sums) {
  float* n = sums.n.data();
  float* u = sums.u.data();
  float* v = sums.v.data();
  float* uu = sums.uu.data();
  float* uv = sums.uv.data();
  float* vv = sums.vv.data();
  float* q = sums.q.data();
  float* qu = sums.qu.data();
  float* qv = sums.qv.data();
  for (int i = 0; i < count; ++i) {
    const float difference = neighbor[i] - center[i];
    const float weight = std::abs(difference) <= max_change * center[i] ? 1.0F : 0.0F;
    const float value = weight * difference;  // relative to the centre: keeps precision
    n[i] += weight;
    u[i] += weight * du;
    v[i] += weight * dv;
    uu[i] += weight * (du * du);
    uv[i] += weight * (du * dv);
    vv[i] += weight * (dv * dv);
    q[i] += value;
    qu[i] += value * du;
    qv[i] += value * dv;
  }
}

// Solves the fit of one column and turns it into a unit normal towards the camera.
cv::Vec3f NormalFromFit(const FitSums& s, int i, float inverse_depth, const cv::Vec3f& point,
                        float du0, float dv0, const CameraIntrinsics& k) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float n = s.n[i];
  if (inverse_depth <= 0 || n < 3) return {nan, nan, nan};
  // Normal equations of the centred fit.
  const float uu = s.uu[i] - s.u[i] * s.u[i] / n;
  const float uv = s.uv[i] - s.u[i] * s.v[i] / n;
  const float vv = s.vv[i] - s.v[i] * s.v[i] / n;
  const float qu = s.qu[i] - s.q[i] * s.u[i] / n;
  const float qv = s.qv[i] - s.q[i] * s.v[i] / n;
  const float determinant = uu * vv - uv * uv;
  if (determinant < 1e-3F) return {nan, nan, nan};  // all on one line
  const float a = (qu * vv - qv * uv) / determinant;
  const float b = (qv * uu - qu * uv) / determinant;
  const float c = inverse_depth + (s.q[i] - a * s.u[i] - b * s.v[i]) / n;
  // 1/z = n·ray / d with ray = ((u - cx) / fx, (v - cy) / fy, 1).
  cv::Vec3f normal(a * static_cast<float>(k.fx_px), b * static_cast<float>(k.fy_px),
                   c - a * du0 - b * dv0);
  normal /= static_cast<float>(cv::norm(normal));
  return normal.dot(point) > 0 ? -normal : normal;
}

// Every step-th value of a row, packed, so that the sums run over adjacent memory.
void PackRow(const float* row, int count, int step, std::vector<float>& packed) {
  for (int i = 0; i < count; ++i) packed[i] = row[i * step];
}

}  // namespace

cv::Mat EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                        const NormalOptions& options, int step) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int radius = options.window_radius_px;
  const float max_change = static_cast<float>(options.max_depth_change);
  const cv::Mat inverse = PaddedInverseDepth(points, radius);
  const int count = (points.cols + step - 1) / step;
  cv::Mat normals(points.size(), CV_32FC3, cv::Scalar::all(nan));
  FitSums sums(count);
  std::vector<float> center(count);
  std::vector<float> neighbor(count);

  for (int row = 0; row < points.rows; row += step) {
    sums.Reset();
    PackRow(inverse.ptr<float>(row + radius) + radius, count, step, center);
    for (int dv = -radius; dv <= radius; ++dv) {
      const float* line = inverse.ptr<float>(row + radius + dv) + radius;
      for (int du = -radius; du <= radius; ++du) {
        const float* shifted = line + du;
        if (step > 1) PackRow(shifted, count, step, neighbor);
        AccumulateOffset(center.data(), step > 1 ? neighbor.data() : shifted, count,
                         static_cast<float>(du), static_cast<float>(dv), max_change, sums);
      }
    }
    const float dv0 = static_cast<float>(row - intrinsics.cy_px);
    for (int i = 0; i < count; ++i) {
      const int col = i * step;
      const float du0 = static_cast<float>(col - intrinsics.cx_px);
      normals.at<cv::Vec3f>(row, col) =
          NormalFromFit(sums, i, center[i], points.at<cv::Vec3f>(row, col), du0, dv0, intrinsics);
    }
  }
  return normals;
}

}  // namespace fovea
