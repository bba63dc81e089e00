#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace fovea::image_files {

inline void CheckSize(std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
  if (width * height <= kMostPixels) return;
  throw std::runtime_error("it has " + std::to_string(width) + "x" + std::to_string(height) +
                           " pixels, which is too large to be read");
}

}  // namespace fovea::image_files
