#include "tests/support/value_noise.h"

namespace fovea::scenes {
namespace {

double Mix(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

double ValueNoise(const Eigen::Vector3d& point, std::uint32_t seed) {
  const Eigen::Vector3d base = point.array().floor();
  const Eigen::Vector3d f = point - base;
  const Eigen::Vector3d t = f.array().square() * (3 - 2 * f.array());
  const auto corner = [&](int dx, int dy, int dz) {
    const auto lattice = [](double value) {
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    };
    return HashToUnit(lattice(base.x() + dx), lattice(base.y() + dy), lattice(base.z() + dz), seed);
  };
  const auto row = [&](int dy, int dz) { return Mix(corner(0, dy, dz), corner(1, dy, dz), t.x()); };
  const auto plane = [&](int dz) { return Mix(row(0, dz), row(1, dz), t.y()); };
  return Mix(plane(0), plane(1), t.z());
}

double HashToUnit(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed) {
  std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ z * 0xC2B2AE3DU ^ seed * 0x27D4EB2FU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU;  // the mixing steps of lowbias32
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return static_cast<double>(h ^ (h >> 15)) * 0x1p-32;
}

}  // namespace fovea::scenes
