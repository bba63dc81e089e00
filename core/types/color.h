// Colours by name.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace fovea {

// The eleven basic colour terms of English (Berlin and Kay 1969).
enum class ColorName {
  kBlack,
  kGray,
  kWhite,
  kRed,
  kOrange,
  kYellow,
  kGreen,
  kBlue,
  kPurple,
  kPink,
  kBrown,
};
inline constexpr std::size_t kNumColorNames = 11;

// The pixels of an object that have one name.
struct ColorPart {
  ColorName name = ColorName::kGray;
  float share = 0;                                     // of its mask, 0 … 1
  std::array<std::uint8_t, 3> mean{};                  // RGB
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  // mean of their points, camera frame, metres
};

}  // namespace fovea
