#include "core/depth/normals.h"

#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

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

// The columns relative to the principal point.
std::vector<float> RelativeColumns(int cols, double cx_px) {
  std::vector<float> relative(cols);
  for (int col = 0; col < cols; ++col) relative[col] = static_cast<float>(col - cx_px);
  return relative;
}

// The normals of one row.
struct RowFit {
  const cv::Mat& points;
  const cv::Mat& inverse;
  const std::vector<float>& relative_cols;
  const CameraIntrinsics& intrinsics;
  const NormalOptions& options;
  int step;

  FOVEA_INLINE void Run(int row, cv::Mat& normals) const {
    const int radius = options.window_radius_px;
    const auto dv0 = static_cast<float>(row - intrinsics.cy_px);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row);
    for (int first = 0; first < points.cols; first += kLanes * step) {
      const float* center = inverse.ptr<float>(row + radius) + radius + first;
      const Lanes at_center = LoadLanes(center, step);
      if (LargestLane(at_center) <= 0) continue;
      const PlaneFit fit = Solve(SumWindows(center, inverse.step1(), step, radius,
                                            static_cast<float>(options.max_depth_change)),
                                 at_center);
      const Vectors n =
          NormalsOf(fit, LoadLanes(relative_cols.data() + first, step), dv0, intrinsics);
      for (int lane = 0; lane < kLanes && first + lane * step < points.cols; ++lane) {
        const int col = first + lane * step;
        if (center[col - first] <= 0 || std::isnan(fit.a[lane])) continue;
        normal[col] = TowardsCamera({n.x[lane], n.y[lane], n.z[lane]}, point[col]);
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
  const std::vector<float> relative_cols =
      RelativeColumns(points.cols + kLanes * step, intrinsics.cx_px);
  const RowFit fit{points, inverse, relative_cols, intrinsics, options, step};
  RunInWidestRegisters([&] {
    for (int row = 0; row < points.rows; row += step) fit.Run(row, normals);
  });
  return normals;
}

}  // namespace fovea
