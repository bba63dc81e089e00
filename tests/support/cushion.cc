#include "tests/support/cushion.h"

#include <algorithm>
#include <cmath>

#include "tests/support/value_noise.h"

namespace fovea::scenes {
namespace {

// How far a point is above the upper side; negative within.
double Clearance(const Shape& cushion, const Eigen::Vector3d& p) {
  return p.z() + cushion.size_m.z() / 2 - CushionHeight(cushion, p.x(), p.y());
}

Eigen::Vector3d NormalAt(const Shape& cushion, const Eigen::Vector3d& p) {
  constexpr double kStep_m = 5e-4;
  const auto slope = [&](double dx, double dy) {
    return (CushionHeight(cushion, p.x() + dx, p.y() + dy) -
            CushionHeight(cushion, p.x() - dx, p.y() - dy)) /
           (2 * kStep_m);
  };
  return Eigen::Vector3d(-slope(kStep_m, 0), -slope(0, kStep_m), 1).normalized();
}

// Between a point outside and one within.
double Bisected(const Shape& cushion, const Ray& ray, double outside, double within) {
  for (int i = 0; i < 30; ++i) {
    const double middle = (outside + within) / 2;
    (Clearance(cushion, ray.At(middle)) > 0 ? outside : within) = middle;
  }
  return within;
}

}  // namespace

double CushionHeight(const Shape& cushion, double x, double y) {
  const Relief& relief = cushion.relief;
  const auto fall = [&](double at, double size_m) {
    const double share = std::min(1.0, std::abs(2 * at / size_m));
    return 1 - std::pow(share, 2 * relief.fullness);
  };
  const double full = fall(x, cushion.size_m.x()) * fall(y, cushion.size_m.y());
  if (full <= 0 || relief.depth_m <= 0) return full * cushion.size_m.z();
  const Eigen::Vector3d p(x / relief.scale_m, y / relief.scale_m, 0);
  const double dent = ValueNoise(p, relief.seed);
  const double crease = std::abs(2 * ValueNoise(1.7 * p, relief.seed + 1) - 1);
  return full * (cushion.size_m.z() - relief.depth_m * (0.6 * dent + 0.4 * crease));
}

std::optional<Hit> IntersectCushion(const Shape& cushion, const Ray& ray, double from, double to) {
  constexpr double kShortest_m = 2.5e-4;
  constexpr double kShare = 0.2;  // of the clearance, since slopes are steep
  const double length = ray.direction.norm();
  double outside = from;
  if (Clearance(cushion, ray.At(from)) <= 0) {  // enters from below, or at the very top
    if (from == 0) return std::nullopt;
    const Eigen::Vector3d entry = ray.At(from);
    return Hit{from, entry.z() < 0 ? -Eigen::Vector3d::UnitZ() : NormalAt(cushion, entry)};
  }
  while (outside < to) {
    const double clear_m = Clearance(cushion, ray.At(outside));
    const double next = outside + std::max(kShortest_m, kShare * clear_m) / length;
    if (Clearance(cushion, ray.At(next)) <= 0) {
      const double t = Bisected(cushion, ray, outside, next);
      if (t >= to) return std::nullopt;
      return Hit{t, NormalAt(cushion, ray.At(t))};
    }
    outside = next;
  }
  return std::nullopt;
}

}  // namespace fovea::scenes
