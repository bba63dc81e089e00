// Smooth noise in space, the same for the same numbers on any machine.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace fovea::scenes {

// In [0, 1]: random values on the integer lattice, interpolated.
double ValueNoise(const Eigen::Vector3d& point, std::uint32_t seed);

// Uniform in [0, 1).
double HashToUnit(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t seed);

}  // namespace fovea::scenes
