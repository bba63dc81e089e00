#include "core/depth/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/interruption.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/depth/normals.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once more for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fovea::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Centres side by side. Each lane computes what a float on its own would, so that the answer has
// the same bits in registers of any width.
using Tag = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Tag>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag()));

HWY_INLINE Lanes Load(const float* from) { return hn::LoadU(Tag(), from); }
HWY_INLINE Lanes All(double value) { return hn::Set(Tag(), static_cast<float>(value)); }

// The sum where `where` holds. Instruction sets with masks add so in one step, the others by adding
// zero: no sum is -0, so that these are the same bits.
HWY_INLINE Lanes AddWhere(hn::Mask<Tag> where, Lanes sum, Lanes value) {
  constexpr bool kAddsByMask = HWY_TARGET <= HWY_AVX3;
  if constexpr (kAddsByMask) return hn::IfThenElse(where, sum + value, sum);
  return sum + hn::IfThenElseZero(where, value);
}

// Weighted sums of the linear fit of 1/z over the windows of the evaluated columns.
struct FitSums {
  Lanes n = All(0), u = All(0), v = All(0);
  Lanes uu = All(0), uv = All(0), vv = All(0);
  Lanes q = All(0), qu = All(0), qv = All(0);

  // Written out, so that it is compiled for the instruction set too.
  HWY_INLINE FitSums() {}  // NOLINT(modernize-use-equals-default)
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
    std::vector<float> inverse(static_cast<std::size_t>(points.cols));
    for (int row = 0; row < points.rows; row += lattice) {
      InterruptionPoint();
      const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
      for (std::size_t col = 0; col < inverse.size(); ++col) {
        const float z = point[col][2], one = 1 / z;
        inverse[col] = z > 0 ? one : 0;
      }
      for (int first = 0; first < step_; first += lattice) {
        float* out = image_.ptr<float>(row + radius_) + Place(first);
        for (int col = first; col < points.cols; col += step_) *out++ = inverse[col];
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
HWY_INLINE FitSums SumWindows(const InverseDepth& inverse, int row, int col,
                              const NormalOptions& options) {
  const Lanes at_center = Load(inverse.At(row, col));
  const Lanes limit = at_center * All(options.max_depth_change);
  const int sample = options.sample_px;
  const int reach = options.window_radius_px / sample * sample;
  const std::ptrdiff_t stride = inverse.RowStride() * sample;
  FitSums sums;
  // One column of the window at a time, so that its offset du is multiplied in once.
  for (int du = -reach; du <= reach; du += sample) {
    FitSums column;
    const float* place = inverse.At(row - reach, col + du);
    Lanes dv = All(-reach);
    for (int i = -reach; i <= reach; i += sample, place += stride, dv = dv + All(sample)) {
      // Relative to the centre, which keeps precision.
      const Lanes difference = Load(place) - at_center;
      const auto same_surface = hn::Le(hn::Abs(difference), limit);
      column.n = AddWhere(same_surface, column.n, All(1));
      column.v = AddWhere(same_surface, column.v, dv);
      column.vv = AddWhere(same_surface, column.vv, dv * dv);
      column.q = AddWhere(same_surface, column.q, difference);
      column.qv = AddWhere(same_surface, column.qv, difference * dv);
    }
    const Lanes offset = All(du);
    sums.n = sums.n + column.n;
    sums.u = sums.u + column.n * offset;
    sums.uu = sums.uu + column.n * offset * offset;
    sums.v = sums.v + column.v;
    sums.uv = sums.uv + column.v * offset;
    sums.vv = sums.vv + column.vv;
    sums.q = sums.q + column.q;
    sums.qu = sums.qu + column.q * offset;
    sums.qv = sums.qv + column.qv;
  }
  return sums;
}

// 1/z = a·u + b·v + c around each centre; `a` is not a number where the window fits no plane.
struct PlaneFit {
  Lanes a, b, c;
};

HWY_INLINE PlaneFit Solve(const FitSums& s, Lanes at_center) {
  const Lanes n = hn::Max(s.n, All(1));
  // Normal equations of the centred fit.
  const Lanes uu = s.uu - s.u * s.u / n;
  const Lanes uv = s.uv - s.u * s.v / n;
  const Lanes vv = s.vv - s.v * s.v / n;
  const Lanes qu = s.qu - s.q * s.u / n;
  const Lanes qv = s.qv - s.q * s.v / n;
  const Lanes determinant = uu * vv - uv * uv;
  const Lanes none = All(std::numeric_limits<float>::quiet_NaN());
  const auto on_a_line = hn::Lt(determinant, All(1e-3));
  const Lanes a = hn::IfThenElse(on_a_line, none, (qu * vv - qv * uv) / determinant);
  const Lanes b = (qv * uu - qu * uv) / determinant;
  return {a, b, at_center + (s.q - a * s.u - b * s.v) / n};
}

// One a lane.
using Values = std::array<float, kLanes>;
struct Vectors {
  Values x, y, z;
};

HWY_INLINE Values ValuesOf(Lanes lanes) {
  Values values;
  hn::StoreU(lanes, Tag(), values.data());
  return values;
}

// 1/z = n·ray / d with ray = ((u - cx) / fx, (v - cy) / fy, 1); (du0, dv0) is the pixel relative
// to the principal point.
HWY_INLINE Vectors NormalsOf(const PlaneFit& fit, Lanes du0, float dv0, const CameraIntrinsics& k) {
  const Lanes x = fit.a * All(k.fx_px);
  const Lanes y = fit.b * All(k.fy_px);
  const Lanes z = fit.c - fit.a * du0 - fit.b * All(dv0);
  const Vectors unscaled{ValuesOf(x), ValuesOf(y), ValuesOf(z)};
  Values inverse_lengths;
  for (int lane = 0; lane < kLanes; ++lane) {
    const double nx = unscaled.x[lane], ny = unscaled.y[lane], nz = unscaled.z[lane];
    inverse_lengths[lane] = 1 / static_cast<float>(std::sqrt(nx * nx + ny * ny + nz * nz));
  }
  const Lanes scale = Load(inverse_lengths.data());
  return {ValuesOf(x * scale), ValuesOf(y * scale), ValuesOf(z * scale)};
}

// Of the points `step` apart; NaN where `center`, the inverse depth, is 0. Written for a loop that
// the compiler vectorises.
HWY_INLINE void StoreTowardsCamera(const Vectors& normals, const float* center,
                                   const cv::Vec3f* points, int step, int count, cv::Vec3f* out) {
  for (int lane = 0; lane < count; ++lane) {
    const cv::Vec3f& point = points[std::ptrdiff_t{lane} * step];
    const float x = normals.x[lane], y = normals.y[lane], z = normals.z[lane];
    const float sign = x * point[0] + y * point[1] + z * point[2] > 0 ? -1.0F : 1.0F;
    const float scale = center[lane] > 0 ? sign : std::numeric_limits<float>::quiet_NaN();
    out[lane] = {x * scale, y * scale, z * scale};
  }
}

// Every step-th column relative to the principal point, and as many more as a load may reach.
std::vector<float> RelativeColumns(int cols, int step, double cx_px) {
  std::vector<float> relative;
  relative.reserve(static_cast<std::size_t>(cols / step + kLanes + 1));
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

  HWY_INLINE void Run(int row, cv::Mat& normals) const {
    const int step = options.step_px;
    const cv::Vec3f none = cv::Vec3f::all(std::numeric_limits<float>::quiet_NaN());
    const auto dv0 = static_cast<float>(row - intrinsics.cy_px);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row / step);
    for (int first = 0; first < points.cols; first += kLanes * step) {
      const float* center = inverse.At(row, first);
      const Lanes at_center = Load(center);
      const int count = std::min(kLanes, normals.cols - first / step);
      if (hn::AllTrue(Tag(), hn::Le(at_center, All(0)))) {
        std::fill_n(normal + first / step, count, none);
        continue;
      }
      const PlaneFit fit = Solve(SumWindows(inverse, row, first, options), at_center);
      const Vectors n = NormalsOf(fit, Load(relative_cols.data() + first / step), dv0, intrinsics);
      StoreTowardsCamera(n, center, point + first, step, count, normal + first / step);
    }
  }
};

}  // namespace

NormalMap FitNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                     const NormalOptions& options) {
  const InverseDepth inverse(points, options);
  const int step = options.step_px;
  cv::Mat normals((points.rows + step - 1) / step, (points.cols + step - 1) / step, CV_32FC3);
  const std::vector<float> relative_cols = RelativeColumns(points.cols, step, intrinsics.cx_px);
  const RowFit fit{points, inverse, relative_cols, intrinsics, options};
  for (int row = 0; row < points.rows; row += step) {
    InterruptionPoint();
    fit.Run(row, normals);
  }
  return {normals, step};
}

}  // namespace fovea::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fovea {

HWY_EXPORT(FitNormals);

NormalMap EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                          const NormalOptions& options) {
  return HWY_DYNAMIC_DISPATCH(FitNormals)(points, intrinsics, options);
}

}  // namespace fovea
#endif
