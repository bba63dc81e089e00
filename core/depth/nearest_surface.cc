#include "core/depth/nearest_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <tuple>

namespace fovea {
namespace {

// Pixels this near to a triangle are in it: rounding must not open a gap between two triangles.
constexpr double kSlack_px = 1e-3;

// First and last pixel between two coordinates, within 0 … count - 1; none if first > last.
struct Span {
  int first = 0, last = -1;

  Span(double low, double high, int count) {
    const double from = std::max(0.0, std::ceil(low - kSlack_px));
    const double to = std::min(count - 1.0, std::floor(high + kSlack_px));
    if (!(from <= to)) return;
    first = static_cast<int>(from);
    last = static_cast<int>(to);
  }
};

// Where a triangle's side crosses a row.
class Side {
 public:
  // `clockwise`: the way round the triangle that a → b goes, with v pointing down.
  Side(const ImagePoint& a, const ImagePoint& b, bool clockwise)
      : u_(a.u), v_(a.v), slope_((b.u - a.u) / (b.v - a.v)) {
    // Along a level side the rows decide alone.
    is_level_ = !(std::abs(b.v - a.v) > 1e-9);
    is_right_ = (b.v > a.v) == clockwise;
  }

  void Limit(int row, double& low, double& high) const {
    if (is_level_) return;
    const double u = u_ + slope_ * (row - v_);
    if (is_right_) {
      high = std::min(high, u);
    } else {
      low = std::max(low, u);
    }
  }

 private:
  double u_, v_, slope_;
  bool is_level_ = false, is_right_ = false;
};

// 1/z over a triangle with twice the signed area `area`.
class Plane {
 public:
  Plane(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c, double area) : a_(a) {
    const double b_w = b.inverse_z - a.inverse_z, c_w = c.inverse_z - a.inverse_z;
    by_u_ = (b_w * (c.v - a.v) - c_w * (b.v - a.v)) / area;
    by_v_ = (c_w * (b.u - a.u) - b_w * (c.u - a.u)) / area;
    std::tie(lowest_, highest_) = std::minmax({a.inverse_z, b.inverse_z, c.inverse_z});
  }

  // The range of the points holds what a sliver's gradient makes of rounding; also NaN.
  float At(int u, int v) const {
    const double w = a_.inverse_z + by_u_ * (u - a_.u) + by_v_ * (v - a_.v);
    return static_cast<float>(std::max(lowest_, std::min(highest_, w)));
  }

 private:
  ImagePoint a_;
  double by_u_, by_v_, lowest_, highest_;
};

}  // namespace

NearestSurface::NearestSurface(const cv::Size& size, double max_steps)
    : inverse_z_(cv::Mat::zeros(size, CV_32FC1)), steps_left_(max_steps) {}

void NearestSurface::Draw(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c) {
  if (!(std::min({a.inverse_z, b.inverse_z, c.inverse_z}) > 0)) return;
  const auto [top, bottom] = std::minmax({a.v, b.v, c.v});
  const Span rows(top, bottom, inverse_z_.rows);
  const auto [left, right] = std::minmax({a.u, b.u, c.u});
  if (rows.first > rows.last || !(right >= -kSlack_px && left <= inverse_z_.cols)) return;
  const double area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  if (!(std::abs(area) > 0 && std::isfinite(area))) return;

  const Side sides[] = {{a, b, area > 0}, {b, c, area > 0}, {c, a, area > 0}};
  const Plane plane(a, b, c, area);
  steps_left_ -= rows.last - rows.first + 1;
  for (int row = rows.first; row <= rows.last; ++row) {
    double low = left, high = right;
    for (const Side& side : sides) side.Limit(row, low, high);
    const Span columns(low, high, inverse_z_.cols);
    steps_left_ -= columns.last - columns.first + 1;
    float* inverse_z = inverse_z_.ptr<float>(row);
    for (int col = columns.first; col <= columns.last; ++col) {
      inverse_z[col] = std::max(inverse_z[col], plane.At(col, row));
    }
  }
  if (steps_left_ < 0) throw std::invalid_argument("the surfaces cover the image too often");
}

cv::Mat NearestSurface::Depth() const {
  cv::Mat depth_m(inverse_z_.size(), CV_32FC1);
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* inverse_z = inverse_z_.ptr<float>(row);
    float* z = depth_m.ptr<float>(row);
    for (int col = 0; col < depth_m.cols; ++col) {
      z[col] = inverse_z[col] > 0 ? 1 / inverse_z[col] : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return depth_m;
}

}  // namespace fovea
