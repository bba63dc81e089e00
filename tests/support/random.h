// Random numbers that are the same with every standard library: std::mt19937_64 is specified to
// the bit, the distributions of the standard are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace fovea::scenes {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t Bits() { return engine_(); }

  // Uniform in [0, 1), with 53 bits.
  double Unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  double Uniform(double low, double high) { return low + (high - low) * Unit(); }

  // Uniform in low … high, both included.
  int Integer(int low, int high) { return low + static_cast<int>(Unit() * (high - low + 1)); }

  bool Chance(double probability) { return Unit() < probability; }

  // Mean 0, standard deviation 1 (Box and Muller).
  double Normal() {
    const double radius = std::sqrt(-2 * std::log(1 - Unit()));
    return radius * std::cos(2 * std::numbers::pi * Unit());
  }

  template <typename Container>
  const auto& Pick(const Container& choices) {
    return choices[static_cast<std::size_t>(Integer(0, static_cast<int>(choices.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace fovea::scenes
