#include "tests/support/material.h"

#include <cmath>

#include "tests/support/value_noise.h"

namespace fovea::scenes {
namespace {

double Clouds(const Eigen::Vector3d& point, std::uint32_t seed) {
  return (4 * ValueNoise(point, seed) + 2 * ValueNoise(2 * point, seed + 1) +
          ValueNoise(4 * point, seed + 2)) /
         7;
}

bool Odd(double value) { return std::fmod(std::abs(std::floor(value)), 2) == 1; }

// How much of the second colour shows, 0 … 1.
double ShareOfSecond(const Material& material, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = point / material.scale_m;
  switch (material.pattern) {
    case Pattern::kPlain:
      return 0;
    case Pattern::kStripes:
      return Odd(p.z()) ? 1 : 0;
    case Pattern::kChecker:
      return Odd(p.x()) != (Odd(p.y()) != Odd(p.z())) ? 1 : 0;
    case Pattern::kNoise:
      return Clouds(p, material.seed);
    case Pattern::kWood:
      return Clouds(p.cwiseProduct(Eigen::Vector3d(0.08, 1, 1)), material.seed);
    case Pattern::kPrint: {
      const bool in_band = std::abs(p.z()) < 1.2 || std::abs(p.x()) < 0.6;
      return in_band ? 1 - 0.6 * std::round(ValueNoise(3 * p, material.seed)) : 0;
    }
  }
  return 0;
}

}  // namespace

Material Plain(const Eigen::Vector3d& color) { return {.color = color, .second_color = color}; }

Eigen::Vector3d AlbedoAt(const Material& material, const Eigen::Vector3d& point) {
  const double share = ShareOfSecond(material, point);
  return (1 - share) * material.color + share * material.second_color;
}

}  // namespace fovea::scenes
